using System;
using System.IO;
using System.Net.Sockets;
using System.Text;
using System.Text.Json;

namespace Rabit.Diagnostics.Tests;

/// <summary>A client that sends lines, or whatever else, and reads lines.</summary>
internal sealed class TestClient : IDisposable
{
    private readonly Socket _socket = new(AddressFamily.Unix, SocketType.Stream, ProtocolType.Unspecified)
    {
        ReceiveTimeout = 60_000,
    };

    private readonly StreamReader _reader;

    public TestClient(string path)
    {
        _socket.Connect(new UnixDomainSocketEndPoint(path));
        _reader = new StreamReader(new NetworkStream(_socket));
    }

    /// <summary>Bytes that have come and were not read.</summary>
    public int Waiting => _socket.Available;

    public TestClient Send(string line) => SendRaw(Encoding.UTF8.GetBytes(line + "\n"));

    public TestClient SendRaw(ReadOnlySpan<byte> bytes)
    {
        while (!bytes.IsEmpty)
            bytes = bytes[_socket.Send(bytes)..];
        return this;
    }

    public void EndSending() => _socket.Shutdown(SocketShutdown.Send);

    /// <returns>Null at the end.</returns>
    public JsonElement? Read()
    {
        try
        {
            return _reader.ReadLine() is { } line ? JsonDocument.Parse(line).RootElement : null;
        }
        catch (IOException e)
            when (e.InnerException is SocketException { SocketErrorCode: SocketError.ConnectionReset })
        {
            return null;
        }
    }

    /// <summary>Reads a line of a type, and skips none.</summary>
    public JsonElement Read(string type)
    {
        JsonElement line = Read() ?? throw new EndOfStreamException("There is no line more.");
        string found = line.GetProperty("type").GetString()!;
        return found == type ? line : throw new InvalidDataException($"{found} instead of {type}: {line}");
    }

    public JsonElement Ask(string type, string request) => Send(request).Read(type);

    public void Dispose()
    {
        _reader.Dispose();
        _socket.Dispose();
    }
}
