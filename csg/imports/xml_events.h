// XML by its events: expat, through which nothing is thrown.
#pragma once

#include <expat.h>

#include <exception>
#include <map>
#include <memory>
#include <new>
#include <string>
#include <string_view>

namespace cnrg {

using XmlAttributes = std::map<std::string, std::string, std::less<>>;

class XmlEvents {
 public:
  XmlEvents() : parser_(XML_ParserCreate(nullptr), XML_ParserFree) {
    if (!parser_) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), on_begin, on_end);
    XML_SetCharacterDataHandler(parser_.get(), on_characters);
    XML_SetStartDoctypeDeclHandler(parser_.get(), on_doctype);
  }
  virtual ~XmlEvents() = default;
  XmlEvents(const XmlEvents&) = delete;
  XmlEvents& operator=(const XmlEvents&) = delete;

 protected:
  /// To its end, or to the event that calls `stop`.
  void parse(std::string_view text) {
    constexpr std::size_t kAtOnce = 1 << 26;  // its lengths are of type int
    for (std::size_t at = 0; at < text.size() && !stopped_; at += kAtOnce) {
      const std::size_t n = std::min(kAtOnce, text.size() - at);
      const auto status = XML_Parse(parser_.get(), text.data() + at, static_cast<int>(n), at + n == text.size());
      if (fault_) std::rethrow_exception(fault_);
      if (status != XML_STATUS_ERROR || stopped_) continue;
      const XML_Error code = XML_GetErrorCode(parser_.get());
      if (code == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
      fail_as_no_xml(std::string("this is no XML: ") + XML_ErrorString(code));
    }
  }
  void stop() {
    stopped_ = true;
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  // Of the current event; since expat 2.9 by functions of their own for 64 bits.
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9
  std::size_t line() const { return XML_GetCurrentLineNumber64(parser_.get()); }
  std::size_t end_of_event() const {
    return static_cast<std::size_t>(XML_GetCurrentByteIndex64(parser_.get())) +
           XML_GetCurrentByteCount64(parser_.get());
  }
#else
  std::size_t line() const { return XML_GetCurrentLineNumber(parser_.get()); }
  std::size_t end_of_event() const {
    return static_cast<std::size_t>(XML_GetCurrentByteIndex(parser_.get())) +
           static_cast<std::size_t>(XML_GetCurrentByteCount(parser_.get()));
  }
#endif

  virtual void begin(const char* name, XmlAttributes attributes) = 0;
  virtual void end() {}
  virtual void characters(std::string_view) {}
  /// Throw; the second what is wrong, without a remedy.
  virtual void refuse_doctype() const = 0;
  virtual void fail_as_no_xml(const std::string& fault) const = 0;

 private:
  std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser_;
  std::exception_ptr fault_;
  bool stopped_ = false;

  template <class Body>
  static void guarded(void* user, const Body& body) {
    auto& events = *static_cast<XmlEvents*>(user);
    if (events.fault_) return;
    try {
      body(events);
    } catch (...) {
      events.fault_ = std::current_exception();
      XML_StopParser(events.parser_.get(), XML_FALSE);
    }
  }
  static void on_begin(void* user, const char* name, const char** attributes) {
    guarded(user, [&](XmlEvents& events) {
      XmlAttributes given;
      for (; *attributes != nullptr; attributes += 2) given[attributes[0]] = attributes[1];
      events.begin(name, std::move(given));
    });
  }
  static void on_end(void* user, const char*) {
    guarded(user, [](XmlEvents& events) { events.end(); });
  }
  static void on_characters(void* user, const char* text, int length) {
    guarded(user, [&](XmlEvents& events) { events.characters({text, static_cast<std::size_t>(length)}); });
  }
  static void on_doctype(void* user, const char*, const char*, const char*, int) {
    guarded(user, [](XmlEvents& events) { events.refuse_doctype(); });
  }
};

}  // namespace cnrg
