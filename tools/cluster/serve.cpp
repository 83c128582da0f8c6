#include "cluster/serve.h"

#include <memory>

#include "cluster/mailbox.h"
#include "cluster/work.h"
#include "tagmint/codec/search/crew.h"

namespace tagmint::cluster {

int serve(const boost::mpi::communicator& ranks, int threads) {
  std::unique_ptr<codec::SearchCrew> crew;
  while (true) {
    const Task task = receive_task(ranks);
    switch (task.kind) {
      case Task::Kind::Begin:
        crew.reset();  // the memory of the last search first
        crew = codec::local_crew(parse_rules(task.rules), task.number > 0 ? task.number : threads);
        break;
      case Task::Kind::Sift:
      case Task::Kind::ListOpen:
        if (!task.new_codes.empty()) crew->learn(task.new_codes);
        send_answer(ranks, work_on(task.kind, task.chunk, *crew));
        break;
      case Task::Kind::End:
        return task.number;
    }
  }
}

}  // namespace tagmint::cluster
