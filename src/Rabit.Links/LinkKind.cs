namespace Rabit.Links;

/// <summary>The kinds of link that a <see cref="LinkUrl"/> can name.</summary>
public enum LinkKind
{
    /// <summary><c>udpin:ADDRESS:PORT</c>: waits on a UDP port and answers all who send to it.</summary>
    UdpListen,

    /// <summary><c>udpout:HOST:PORT</c>: sends to one UDP address and receives only from it.</summary>
    UdpSend,

    /// <summary><c>tcp:HOST:PORT</c>: connects to a TCP server.</summary>
    TcpClient,

    /// <summary><c>serial:DEVICE:BAUD</c>: a serial line.</summary>
    Serial,

    /// <summary><c>tlog:FILE[?speed=10|max]</c>: plays a recorded flight.</summary>
    RecordedFile,

    /// <summary><c>udpbcast:ADDRESS:PORT</c>: sends to all who listen in a network.</summary>
    UdpBroadcast,

    /// <summary><c>tcpin:ADDRESS:PORT</c>: waits on a TCP port for clients, and serves all of them.</summary>
    TcpServer,
}
