using System;
using System.Diagnostics.CodeAnalysis;
using System.Globalization;

namespace Rabit.Links;

/// <summary>
/// The name of a link as MAVLink users write it: <c>udpin:0.0.0.0:14550</c>, <c>udpout:HOST:PORT</c>,
/// <c>udpbcast:ADDRESS:PORT</c>, <c>tcp:HOST:PORT</c>, <c>tcpin:ADDRESS:PORT</c>, <c>serial:/dev/ttyAMA0:921600</c>,
/// <c>tlog:FILE[?speed=10|max]</c>, each with options behind: <c>serial:/dev/ttyUSB0:57600,name=radio,rate=3600</c>.
/// Immutable; it says what is meant, not whether it exists.
/// </summary>
/// <remarks>
/// An IPv6 address is written in brackets: <c>tcp:[::1]:5760</c>. No port and no baud rate is assumed. The path of a
/// device or file may hold colons. Only <c>?name=value</c> (or a bare <c>?speed</c>) at the very end of a tlog name is
/// an option; any other question mark belongs to the path.
/// </remarks>
/// <example>
/// <code>
/// LinkUrl url = LinkUrl.Parse("tcp:127.0.0.1:5760");   // FormatException: what is wrong, and the right form
/// if (!LinkUrl.TryParse(args[0], out LinkUrl? link, out string? error)) Console.Error.WriteLine(error);
/// </code>
/// </example>
public sealed class LinkUrl
{
    private readonly string? _options;

    private LinkUrl(
        LinkKind kind, string? host = null, int port = 0, string? path = null, int baudRate = 0, double speed = 1,
        LinkSettings? settings = null, string? options = null)
    {
        Settings = settings ?? LinkSettings.None;
        _options = options;
        Kind = kind;
        Host = host;
        Port = port;
        Path = path;
        BaudRate = baudRate;
        Speed = speed;
    }

    /// <summary>Which kind of link.</summary>
    public LinkKind Kind { get; }

    /// <summary>
    /// Name or address of the host, an IPv6 address without its brackets; for <see cref="LinkKind.UdpListen"/> the own
    /// address to listen on. Null for a serial line and a recorded file.
    /// </summary>
    public string? Host { get; }

    /// <summary>Port, 1 to 65535; 0 for a serial line and a recorded file.</summary>
    public int Port { get; }

    /// <summary>Path of the serial device or of the recorded file; null for the others.</summary>
    public string? Path { get; }

    /// <summary>Bits per second of a serial line; 0 for the others.</summary>
    public int BaudRate { get; }

    /// <summary>
    /// How many times faster than it was recorded a file is played: 1 by default, <see cref="double.PositiveInfinity"/>
    /// for <c>max</c> (as fast as it can be taken). 1 for the others.
    /// </summary>
    public double Speed { get; }

    /// <summary>What the options behind it say.</summary>
    public LinkSettings Settings { get; }

    /// <summary>The name in its usual form without the options: where it leads to.</summary>
    public string Address => Kind switch
    {
        LinkKind.UdpListen => $"udpin:{HostAndPort(Host!, Port)}",
        LinkKind.UdpSend => $"udpout:{HostAndPort(Host!, Port)}",
        LinkKind.UdpBroadcast => $"udpbcast:{HostAndPort(Host!, Port)}",
        LinkKind.TcpClient => $"tcp:{HostAndPort(Host!, Port)}",
        LinkKind.TcpServer => $"tcpin:{HostAndPort(Host!, Port)}",
        LinkKind.Serial => $"serial:{Path}:{BaudRate.ToString(CultureInfo.InvariantCulture)}",
        _ => $"tlog:{Path}{SpeedOption()}",
    };

    /// <summary>Whether what is written to it goes out, and comes in, in datagrams.</summary>
    public bool IsDatagram => Kind is LinkKind.UdpListen or LinkKind.UdpSend or LinkKind.UdpBroadcast;

    /// <summary>Reads the name of a link.</summary>
    /// <param name="text">For example <c>udpin:0.0.0.0:14550</c>. The case of the scheme does not matter.</param>
    /// <exception cref="FormatException">
    /// It is not one; the message, one line, says what is wrong and shows the right form.
    /// </exception>
    public static LinkUrl Parse(string? text) =>
        TryParse(text, out LinkUrl? url, out string? error) ? url : throw new FormatException(error);

    /// <summary>Reads the name of a link.</summary>
    /// <param name="text">For example <c>udpin:0.0.0.0:14550</c>. The case of the scheme does not matter.</param>
    /// <param name="url">The link, if it is one.</param>
    /// <param name="error">Otherwise one line that says what is wrong and shows the right form.</param>
    public static bool TryParse(
        string? text, [NotNullWhen(true)] out LinkUrl? url, [NotNullWhen(false)] out string? error)
        =>
            LinkUrlParser.TryParse(text, out url, out error);

    /// <summary>The name in its usual form; parsing it gives an equal one.</summary>
    public override string ToString() => _options is null ? Address : $"{Address},{_options}";

    internal LinkUrl With(LinkSettings settings, string options)
        => new(Kind, Host, Port, Path, BaudRate, Speed, settings, options);

    internal static LinkUrl ForHost(LinkKind kind, string host, int port) => new(kind, host: host, port: port);

    internal static LinkUrl ForSerial(string device, int baudRate)
        => new(LinkKind.Serial, path: device, baudRate: baudRate);

    internal static LinkUrl ForFile(string path, double speed) => new(LinkKind.RecordedFile, path: path, speed: speed);

    private static string HostAndPort(string host, int port)
    {
        string portText = port.ToString(CultureInfo.InvariantCulture);
        return host.Contains(':') ? $"[{host}]:{portText}" : $"{host}:{portText}";
    }

    private string SpeedOption()
    {
        if (double.IsPositiveInfinity(Speed)) return "?speed=max";
        return Speed.Equals(1) ? "" : $"?speed={Speed.ToString("R", CultureInfo.InvariantCulture)}";
    }
}
