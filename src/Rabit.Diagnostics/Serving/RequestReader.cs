using System;
using System.Net.Sockets;
using System.Text.Json;
using Rabit.Diagnostics.Protocol;

namespace Rabit.Diagnostics.Serving;

/// <summary>Cuts what a client sends into requests, none longer than it may be. The session's thread only.</summary>
internal sealed class RequestReader(Socket socket, int maxLength)
{
    private const byte LineBreak = (byte)'\n';
    private const int MaxShown = 60;

    private readonly byte[] _buffer = new byte[maxLength + 1];
    private int _length;

    /// <summary>Takes what has arrived.</summary>
    /// <returns>False at the end of what the client sends.</returns>
    public bool TryReceive()
    {
        int received = socket.Receive(_buffer.AsSpan(_length), SocketFlags.None, out SocketError error);
        if (error == SocketError.WouldBlock)
            return true;
        if (error != SocketError.Success)
            throw new SocketException((int)error);
        _length += received;
        return received > 0;
    }

    /// <summary>Whether a whole line is there, or more than one may have.</summary>
    public bool HasLine => _length > maxLength || _buffer.AsSpan(0, _length).Contains(LineBreak);

    /// <summary>Takes the next line.</summary>
    /// <exception cref="RefusedRequestException">It is too long, or no request.</exception>
    public RequestLine Take()
    {
        int end = _buffer.AsSpan(0, _length).IndexOf(LineBreak);
        if (end < 0)
            throw new RefusedRequestException(
                FormattableString.Invariant($"A request has at most {maxLength} bytes and ends with a line break."),
                endsSession: true);
        try
        {
            return Parse(_buffer.AsSpan(0, end));
        }
        finally
        {
            _length -= end + 1;
            _buffer.AsSpan(end + 1, _length).CopyTo(_buffer);
        }
    }

    private static RequestLine Parse(ReadOnlySpan<byte> line)
    {
        try
        {
            return JsonSerializer.Deserialize(line, ProtocolJson.Default.RequestLine)
                ?? throw new RefusedRequestException("A request is an object of JSON, not null.");
        }
        catch (JsonException e)
        {
            string path = e.Path is { Length: > 2 } member ? $"{Shorten(member)}: " : string.Empty;
            throw new RefusedRequestException(
                $"{path}that is no request; one is {{\"request\":\"status\"}} in one line of JSON.");
        }
    }

    private static string Shorten(string text) => text.Length <= MaxShown ? text : text[..MaxShown] + "...";
}
