using System;
using System.Net.Sockets;
using Rabit.Diagnostics.Protocol;

namespace Rabit.Diagnostics.Serving;

/// <summary>
/// One client, on a thread of its own: answers its requests, and sends it what it has asked for again and again. What
/// it costs, a slow or hostile one too, it costs this thread.
/// </summary>
internal sealed class ClientSession : IDisposable
{
    private static readonly TimeSpan Second = TimeSpan.FromSeconds(1);

    private readonly Socket _socket;
    private readonly ServedProgram _program;
    private readonly ClientLimits _limits;
    private readonly ClientCounters _counters;
    private readonly ClientLines _lines;
    private readonly RequestReader _reader;
    private readonly RequestHandler _handler;
    private long _lastRequest;
    private bool _hasAsked;
    private long _secondBegan;
    private int _inThisSecond;

    public ClientSession(Socket socket, ServedProgram program, ClientLimits limits, ClientCounters counters)
    {
        socket.Blocking = false;
        _socket = socket;
        _program = program;
        _limits = limits;
        _counters = counters;
        _lines = new ClientLines(socket, limits.Send);
        _reader = new RequestReader(socket, limits.MaxRequestLength);
        _handler = new RequestHandler(program, limits, _lines);
        _lastRequest = _secondBegan = program.Clock.GetTimestamp();
    }

    /// <summary>Until the client goes, or must go. Never throws.</summary>
    public void Run()
    {
        try
        {
            _lines.Send(_program.Hello, ProtocolJson.Default.HelloLine);
            while (Step())
            {
                // Until it ends.
            }
        }
        catch (SlowClientException)
        {
            _counters.Drop();
        }
        catch (Exception e) when (e is SocketException or ObjectDisposedException)
        {
            // It has gone, or the diagnostics are closed.
        }
        catch (Exception e)
        {
            // Whatever it is, a client must not end the program.
            _counters.Drop();
            ClientLines.TryRefuse(_socket, "The diagnostics failed: " + e.GetType().Name);
        }
    }

    /// <summary>Ends it soon. Any thread.</summary>
    public void End()
    {
        try
        {
            _socket.Shutdown(SocketShutdown.Both);
        }
        catch (Exception e) when (e is SocketException or ObjectDisposedException)
        {
            // It has gone already.
        }
    }

    public void Dispose() => _socket.Dispose();

    // Waits for a request, for the next sample, or until the client has asked for nothing for too long.
    private bool Step()
    {
        TimeSpan left = _handler.IsStreaming
            ? TimeSpan.MaxValue
            : IdleLimit - _program.Clock.GetElapsedTime(_lastRequest);
        if (left <= TimeSpan.Zero)
        {
            _counters.Drop();
            _lines.SendError("This client has asked for nothing for too long.");
            return false;
        }

        TimeSpan wait = _handler.Remaining < left ? _handler.Remaining : left;
        if (_socket.Poll(wait > TimeSpan.Zero ? wait : TimeSpan.Zero, SelectMode.SelectRead)
            && !(_reader.TryReceive() && AnswerAll()))
            return false;
        _counters.Skip(_handler.SendDue());
        return true;
    }

    private TimeSpan IdleLimit => _hasAsked ? _limits.Idle : _limits.FirstRequest;

    /// <returns>False when the session is over.</returns>
    private bool AnswerAll()
    {
        while (_reader.HasLine)
        {
            try
            {
                CountRequest();
                _handler.Answer(_reader.Take());
                _hasAsked = true;
            }
            catch (RefusedRequestException e)
            {
                _counters.RefuseRequest();
                _lines.SendError(e.Message);
                if (e.EndsSession)
                    return false;
            }
        }

        return true;
    }

    private void CountRequest()
    {
        _lastRequest = _program.Clock.GetTimestamp();
        if (_program.Clock.GetElapsedTime(_secondBegan) >= Second)
        {
            _secondBegan = _lastRequest;
            _inThisSecond = 0;
        }

        if (++_inThisSecond > _limits.MaxRequestsPerSecond)
            throw new RefusedRequestException(
                FormattableString.Invariant($"A client has at most {_limits.MaxRequestsPerSecond} requests a second."),
                endsSession: true);
    }
}
