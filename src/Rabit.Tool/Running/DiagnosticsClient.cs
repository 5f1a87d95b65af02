using System;
using System.IO;
using System.Net.Sockets;
using System.Text;
using System.Text.Json;
using System.Text.Json.Serialization.Metadata;
using Rabit.Diagnostics.Protocol;

namespace Rabit.Tool.Running;

/// <summary>The connection to one program. One thread at a time; <see cref="Dispose"/> on any ends a read.</summary>
internal sealed class DiagnosticsClient : IDisposable
{
    private static readonly TimeSpan AnswerTimeout = TimeSpan.FromSeconds(10);

    private readonly RunningProgram _program;
    private readonly Socket _socket;
    private readonly StreamReader _reader;

    private DiagnosticsClient(RunningProgram program, Socket socket)
    {
        _program = program;
        _socket = socket;
        _reader = new StreamReader(new NetworkStream(socket), Encoding.UTF8);
        Hello = new HelloLine();
    }

    /// <summary>What the program says of itself.</summary>
    public HelloLine Hello { get; private set; }

    /// <param name="program">Which one.</param>
    /// <param name="mayBeOfOthers">Whether it may be of another user, which only root can reach.</param>
    /// <exception cref="RunningException">It has ended, or refuses.</exception>
    public static DiagnosticsClient Connect(RunningProgram program, bool mayBeOfOthers = false)
    {
        var socket = new Socket(AddressFamily.Unix, SocketType.Stream, ProtocolType.Unspecified)
        {
            ReceiveTimeout = (int)AnswerTimeout.TotalMilliseconds,
            SendTimeout = (int)AnswerTimeout.TotalMilliseconds,
        };
        DiagnosticsClient? client = null;
        try
        {
            socket.Connect(new UnixDomainSocketEndPoint(program.Path));
            uint user = PeerUser.Of(socket);
            if (user != PeerUser.Own && !(mayBeOfOthers && PeerUser.Own == PeerUser.Root))
                throw new RunningException(
                    FormattableString.Invariant($"{program} is of another user ({user})."), ToolExitCode.NotFound);
            client = new DiagnosticsClient(program, socket);
            client.Greet();
            return client;
        }
        catch (SocketException e)
        {
            socket.Dispose();
            throw new RunningException($"{program} cannot be reached: {e.Message}.", ToolExitCode.NotFound);
        }
        catch
        {
            client?.Dispose();
            socket.Dispose();
            throw;
        }
    }

    /// <summary>Asks; the answers are read by <see cref="Read(string)"/>.</summary>
    /// <exception cref="RunningException">The program has ended.</exception>
    public void Ask(RequestLine request)
    {
        byte[] line = JsonSerializer.SerializeToUtf8Bytes(request, ProtocolJson.Default.RequestLine);
        try
        {
            for (int sent = 0; sent < line.Length;)
                sent += _socket.Send(line.AsSpan(sent));
            _socket.Send("\n"u8);
        }
        catch (Exception e) when (e is SocketException or ObjectDisposedException)
        {
            throw Ended();
        }
    }

    /// <summary>From now on a line may take as long as that, and as an answer takes.</summary>
    public void AllowSilence(TimeSpan time)
        => _socket.ReceiveTimeout = (int)(time + AnswerTimeout).TotalMilliseconds;

    /// <summary>From now on lines may come or not: none is due when nothing is posted.</summary>
    public void AllowSilence() => _socket.ReceiveTimeout = 0;

    /// <summary>Reads the next line.</summary>
    /// <param name="type">What it must be.</param>
    /// <exception cref="RunningException">It is an error, or the program has ended, or does not answer.</exception>
    public string Read(string type)
    {
        string line = ReadLine();
        string? found = TypeOf(line);
        if (string.Equals(found, "error", StringComparison.Ordinal))
            throw new RunningException(Parse(line, ProtocolJson.Default.ErrorLine).Text, ToolExitCode.NotFound);
        return string.Equals(found, type, StringComparison.Ordinal)
            ? line
            : throw NotUnderstood();
    }

    public T Read<T>(string type, JsonTypeInfo<T> info) => Parse(Read(type), info);

    public void Dispose()
    {
        try
        {
            _socket.Shutdown(SocketShutdown.Both);
        }
        catch (Exception e) when (e is SocketException or ObjectDisposedException)
        {
            // It has gone already.
        }

        _socket.Dispose();
    }

    private void Greet()
    {
        Hello = Read("hello", ProtocolJson.Default.HelloLine);
        if (Hello.Protocol != HelloLine.CurrentProtocol)
            throw new RunningException(
                FormattableString.Invariant(
                    $"{_program} speaks protocol {Hello.Protocol}, this tool {HelloLine.CurrentProtocol}: ")
                    + "install the tool of the version that the program was built with.",
                ToolExitCode.NotFound);
    }

    private string ReadLine()
    {
        try
        {
            return _reader.ReadLine() ?? throw Ended();
        }
        catch (IOException e) when (e.InnerException is SocketException
        {
            SocketErrorCode: SocketError.TimedOut
            or SocketError.WouldBlock
        })
        {
            throw new RunningException($"{_program} does not answer.", ToolExitCode.NotFound);
        }
        catch (Exception e) when (e is IOException or ObjectDisposedException)
        {
            throw Ended();
        }
    }

    private string? TypeOf(string line)
    {
        try
        {
            using JsonDocument document = JsonDocument.Parse(line, new JsonDocumentOptions { MaxDepth = 256 });
            return document.RootElement.GetProperty("type").GetString();
        }
        catch (Exception e) when (e is JsonException or InvalidOperationException
            or System.Collections.Generic.KeyNotFoundException)
        {
            throw NotUnderstood();
        }
    }

    private T Parse<T>(string line, JsonTypeInfo<T> info)
    {
        try
        {
            return JsonSerializer.Deserialize(line, info) ?? throw NotUnderstood();
        }
        catch (JsonException)
        {
            throw NotUnderstood();
        }
    }

    private RunningException Ended() => new($"{_program} has ended.", ToolExitCode.NotFound);

    private RunningException NotUnderstood()
        => new($"{_program} answers what this tool does not know.", ToolExitCode.NotFound);
}
