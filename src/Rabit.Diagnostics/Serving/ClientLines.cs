using System;
using System.Net.Sockets;
using System.Text.Json;
using System.Text.Json.Serialization.Metadata;
using Rabit.Diagnostics.Protocol;

namespace Rabit.Diagnostics.Serving;

/// <summary>
/// Sends lines to a client that may take its time, up to a limit. The session's thread only. The socket does not block.
/// </summary>
internal sealed class ClientLines(Socket socket, TimeSpan timeout)
{
    private static readonly byte[] LineBreak = "\n"u8.ToArray();

    /// <summary>Sends one line to a client that is not let in, if it takes it at once.</summary>
    public static void TryRefuse(Socket client, string text)
    {
        try
        {
            client.Blocking = false;
            new ClientLines(client, TimeSpan.Zero).SendError(text);
        }
        catch (Exception e) when (e is SocketException or SlowClientException)
        {
            // It has gone, or takes nothing: it is not let in either way.
        }
    }

    public void Send<T>(T line, JsonTypeInfo<T> type) => Send(JsonSerializer.SerializeToUtf8Bytes(line, type));

    public void SendError(string text) => Send(new ErrorLine { Text = text }, ProtocolJson.Default.ErrorLine);

    /// <exception cref="SocketException">It has gone.</exception>
    /// <exception cref="SlowClientException">It takes nothing.</exception>
    public void Send(ReadOnlySpan<byte> line)
    {
        SendAll(line);
        SendAll(LineBreak);
    }

    private void SendAll(ReadOnlySpan<byte> bytes)
    {
        while (!bytes.IsEmpty)
        {
            int sent = socket.Send(bytes, SocketFlags.None, out SocketError error);
            if (error is SocketError.WouldBlock or SocketError.NoBufferSpaceAvailable)
            {
                if (!socket.Poll(timeout, SelectMode.SelectWrite))
                    throw new SlowClientException();
                continue;
            }

            if (error != SocketError.Success)
                throw new SocketException((int)error);
            bytes = bytes[sent..];
        }
    }
}
