#pragma once

namespace tagmint::draw {

/// How the one ink of a drawing is named in files that know several ways.
enum class InkModel {
  Gray,  ///< a gray level: what office printers take as pure black
  Key,   ///< the black plate of four-colour print alone (0, 0, 0, K), so that no colour is mixed in
};

}  // namespace tagmint::draw
