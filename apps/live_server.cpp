// SPDX-License-Identifier: GPL-3.0-or-later
// HTTP by Boost.Beast, whose headers CGAL brings along: nothing is linked, and nothing is loaded when the program starts.
#include "apps/live_server.hpp"

// clang-format off: Boost.Asio 1.74 uses std::exchange without including it
#include <utility>
// clang-format on

#include <array>
#include <atomic>
#include <boost/asio.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <random>
#include <string_view>
#include <thread>
#include <vector>

#include "geometry/brep/input_error.hpp"
#include "src/live/live_json.hpp"
#include "src/live/live_page.hpp"

namespace abut {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;
using Request = http::request<http::string_body>;
using Response = http::response<http::string_body>;

constexpr std::size_t most_body = 1 << 20, most_header = 1 << 13;
constexpr int most_connections = 128;
/// Some wait for news, and one for a report.
constexpr int serving_threads = 12;
constexpr std::chrono::seconds read_time{10}, write_time{30};
constexpr std::chrono::milliseconds longest_wait{250};

std::string random_word() {
    std::random_device device;  // of the system: not to be guessed
    std::string word;
    for (int k = 0; k < 4; ++k) {
        std::array<char, 9> digits{};
        std::snprintf(digits.data(), digits.size(), "%08x", static_cast<unsigned>(device()));
        word += digits.data();
    }
    return word;
}

std::string_view view(beast::string_view text) {
    return {text.data(), text.size()};
}

Response response_to(const Request& request, http::status status, const char* type, std::string body) {
    Response response{status, request.version()};
    response.set(http::field::content_type, type);
    response.set(http::field::cache_control, "no-store");
    response.set("X-Content-Type-Options", "nosniff");
    response.set("Referrer-Policy", "no-referrer");  // the address is a secret
    response.set("Content-Security-Policy",
                 "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; connect-src 'self'; "
                 "img-src data: blob:; frame-ancestors 'none'; base-uri 'none'; form-action 'none'");
    response.keep_alive(request.keep_alive());
    response.body() = std::move(body);
    response.prepare_payload();
    return response;
}

constexpr const char* json_type = "application/json";
constexpr const char* html_type = "text/html; charset=utf-8";

/// A whole number out of "after=12"; 0 where there is none.
long number_after(std::string_view query, std::string_view key) {
    const std::size_t at = query.find(key);
    return at == std::string_view::npos ? 0 : std::atol(std::string(query.substr(at + key.size(), 18)).c_str());
}

}  // namespace

struct LiveServer::State {
    explicit State(LiveModel& served) : model(served) {}

    LiveModel& model;
    asio::io_context context{serving_threads};
    tcp::acceptor acceptor{context};
    std::string root = "/" + random_word() + "/";
    std::string host;  // as it is asked for
    std::atomic<int> n_connections = 0;

    Response answer(const Request& request);
    Response serve(const Request& request, const std::string& path, std::string_view query);
    bool is_ours(const Request& request) const;
    asio::awaitable<void> accept_all();
    asio::awaitable<void> talk(beast::tcp_stream stream);
    asio::awaitable<void> requests_of(beast::tcp_stream& stream);
};

/// Pages of other sites may ask this machine too, under names of their own.
bool LiveServer::State::is_ours(const Request& request) const {
    const std::string_view asked = view(request[http::field::host]), origin = view(request[http::field::origin]);
    const std::string named = "localhost" + host.substr(host.find(':'));
    if (asked != host && asked != named) return false;
    return origin.empty() || origin == "http://" + std::string(asked);
}

Response LiveServer::State::serve(const Request& request, const std::string& path, std::string_view query) {
    const bool is_get = request.method() == http::verb::get, is_post = request.method() == http::verb::post;
    if (is_get && path.empty()) return response_to(request, http::status::ok, html_type, live_html());
    if (is_get && path == "news")
        return response_to(request, http::status::ok, json_type, model.news(number_after(query, "after="), longest_wait));
    if (is_get && path == "report") return response_to(request, http::status::ok, html_type, model.report());
    if (is_post && path == "act") return response_to(request, http::status::ok, json_type, model.act(request.body()));
    if (is_post && path == "conditions") {
        model.set_conditions(request.body());
        return response_to(request, http::status::ok, json_type, "{}");
    }
    if (is_post && path == "save") return response_to(request, http::status::ok, json_type, model.save_scene(request.body()));
    return response_to(request, http::status::not_found, json_type, "");
}

Response LiveServer::State::answer(const Request& request) {
    if (!is_ours(request)) return response_to(request, http::status::forbidden, json_type, "");
    const std::string_view target = view(request.target());
    if (target.substr(0, root.size()) != root) return response_to(request, http::status::not_found, json_type, "");
    const std::string_view below = target.substr(root.size()), path = below.substr(0, below.find('?'));
    try {
        return serve(request, std::string(path), below.substr(path.size()));
    } catch (const InputError& error) {
        return response_to(request, http::status::bad_request, json_type, problems_json(error.problems()));
    } catch (const std::exception& error) {
        return response_to(request, http::status::internal_server_error, json_type,
                           problems_json({{"", std::string("an error in the program itself: ") + error.what(),
                                           "please report it with the file"}}));
    }
}

/// Until the other side ends, falls silent, or says what is no request.
asio::awaitable<void> LiveServer::State::requests_of(beast::tcp_stream& stream) {
    beast::flat_buffer buffer(most_header + (1 << 16));
    for (bool goes_on = true; goes_on;) {
        http::request_parser<http::string_body> parser;
        parser.body_limit(most_body);
        parser.header_limit(most_header);
        stream.expires_after(read_time);
        beast::error_code error;
        co_await http::async_read(stream, buffer, parser, asio::redirect_error(asio::use_awaitable, error));
        const bool is_http = error.category() == make_error_code(http::error::bad_method).category();
        if (error && (!is_http || error == http::error::end_of_stream)) co_return;
        Response response = error == http::error::body_limit ? response_to({}, http::status::payload_too_large, json_type, "")
                            : error                          ? response_to({}, http::status::bad_request, json_type, "")
                                                             : answer(parser.get());
        if (error) response.keep_alive(false);
        goes_on = response.keep_alive();
        stream.expires_after(write_time);
        co_await http::async_write(stream, response, asio::use_awaitable);
    }
    beast::error_code ignored;
    stream.socket().shutdown(tcp::socket::shutdown_send, ignored);
}

asio::awaitable<void> LiveServer::State::talk(beast::tcp_stream stream) {
    ++n_connections;
    try {
        if (n_connections <= most_connections) {
            stream.socket().set_option(tcp::no_delay(true));
            co_await requests_of(stream);
        }
    } catch (const boost::system::system_error&) {  // the other side is gone
    }
    --n_connections;
}

asio::awaitable<void> LiveServer::State::accept_all() {
    for (;;) {
        beast::error_code error;
        tcp::socket socket =
            co_await acceptor.async_accept(asio::make_strand(context), asio::redirect_error(asio::use_awaitable, error));
        if (error == asio::error::operation_aborted) co_return;
        if (error) continue;
        const auto executor = socket.get_executor();
        asio::co_spawn(executor, talk(beast::tcp_stream(std::move(socket))), asio::detached);
    }
}

LiveServer::LiveServer(LiveModel& model, int port) : state_(std::make_unique<State>(model)) {
    State& s = *state_;
    const tcp::endpoint endpoint(asio::ip::address_v4::loopback(), static_cast<unsigned short>(port));
    try {
        s.acceptor.open(endpoint.protocol());
        s.acceptor.set_option(asio::socket_base::reuse_address(true));
        s.acceptor.bind(endpoint);
        s.acceptor.listen();
    } catch (const boost::system::system_error& error) {
        throw InputError("--port " + std::to_string(port), "it cannot be listened at: " + error.code().message(),
                         "give another one, or none for any that is free");
    }
    s.host = "127.0.0.1:" + std::to_string(s.acceptor.local_endpoint().port());
}

LiveServer::~LiveServer() = default;

std::string LiveServer::address() const {
    return "http://" + state_->host + state_->root;
}

void LiveServer::run() {
    State& s = *state_;
    asio::signal_set ends(s.context, SIGINT, SIGTERM, SIGHUP);
    ends.async_wait([&](const beast::error_code&, int) {
        s.model.stop();
        s.context.stop();
    });
    asio::co_spawn(s.context, s.accept_all(), asio::detached);
    std::vector<std::jthread> others;
    for (int k = 1; k < serving_threads; ++k) others.emplace_back([&] { s.context.run(); });
    s.context.run();
}

}  // namespace abut
