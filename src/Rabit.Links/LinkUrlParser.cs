using System;
using System.Diagnostics.CodeAnalysis;
using System.Globalization;
using System.Net;
using System.Net.Sockets;

namespace Rabit.Links;

/// <summary>
/// Reads a <see cref="LinkUrl"/>. Every error names the text that was given, what is wrong with it, and the right form.
/// </summary>
internal static class LinkUrlParser
{
    private const string UdpListenForm = "udpin:ADDRESS:PORT, for example udpin:0.0.0.0:14550";
    private const string UdpSendForm = "udpout:HOST:PORT, for example udpout:192.168.1.10:14550";
    private const string TcpForm = "tcp:HOST:PORT, for example tcp:127.0.0.1:5760";
    private const string TcpServerForm = "tcpin:ADDRESS:PORT, for example tcpin:0.0.0.0:5760";
    private const string BroadcastForm = "udpbcast:ADDRESS:PORT, for example udpbcast:192.168.1.255:14550";
    private const string SerialForm = "serial:DEVICE:BAUD, for example serial:/dev/ttyAMA0:921600";
    private const string FileForm = "tlog:FILE[?speed=10|max], for example tlog:flight.tlog?speed=10";
    private const string AllForms =
        "udpin:ADDRESS:PORT, udpout:HOST:PORT, udpbcast:ADDRESS:PORT, tcp:HOST:PORT, tcpin:ADDRESS:PORT, "
            + "serial:DEVICE:BAUD or tlog:FILE[?speed=10|max]";

    private const string SpeedOption = "speed";

    // No machine comes near it: more is max.
    private const double MaxSpeed = 1_000_000;

    public static bool TryParse(
        string? text, [NotNullWhen(true)] out LinkUrl? url, [NotNullWhen(false)] out string? error)
    {
        string trimmed = text?.Trim() ?? "";
        url = null;
        error = Parse(trimmed, ref url);
        if (error is not null) url = null;
        return error is null && url is not null;
    }

    // Each parser gives the error, or null and the link.
    private static string? Parse(string text, ref LinkUrl? url)
    {
        if (text.Length == 0) return $"the name of a link is empty; write {AllForms}";
        int colon = text.IndexOf(':');
        if (colon < 0) return $"link '{text}' has no scheme; write {AllForms}";

        string rest = SplitOptions(text, colon + 1, out string? options);
        string scheme = text.Substring(0, colon);
        string? fault = scheme.ToUpperInvariant() switch
        {
            "UDPIN" => ParseHost(text, rest, LinkKind.UdpListen, UdpListenForm, ref url),
            "UDPOUT" => ParseHost(text, rest, LinkKind.UdpSend, UdpSendForm, ref url),
            "TCP" => ParseHost(text, rest, LinkKind.TcpClient, TcpForm, ref url),
            "TCPIN" => ParseHost(text, rest, LinkKind.TcpServer, TcpServerForm, ref url),
            "UDPBCAST" => ParseHost(text, rest, LinkKind.UdpBroadcast, BroadcastForm, ref url),
            "SERIAL" => ParseSerial(text, rest, ref url),
            "TLOG" => ParseFile(text, rest, ref url),
            _ => $"link '{text}': the scheme '{scheme}' is unknown; write {AllForms}",
        };
        if (fault is not null || options is null) return fault;
        if (LinkSettingsParser.Parse(options, url!.Kind, out LinkSettings settings) is { } wrong)
            return $"link '{text}': {wrong}";
        url = url.With(settings, options);
        return null;
    }

    // The options begin with the first comma, but paths may hold commas: there, with the first one behind which an
    // option that is known stands, or after a baud rate one that reads as an option.
    private static string SplitOptions(string text, int start, out string? options)
    {
        options = null;
        string rest = text.Substring(start);
        bool isFile = text.StartsWith("tlog:", StringComparison.OrdinalIgnoreCase);
        bool isSerial = text.StartsWith("serial:", StringComparison.OrdinalIgnoreCase);
        for (int comma = rest.IndexOf(','); comma >= 0; comma = rest.IndexOf(',', comma + 1))
        {
            string behind = rest.Substring(comma + 1);
            int end = behind.IndexOf(',');
            string option = end < 0 ? behind : behind.Substring(0, end);
            bool begins = LinkSettingsParser.IsKnown(option) || (!isFile && !isSerial)
                || (isSerial && IsAfterRate(rest, comma));
            if (!begins) continue;
            options = behind;
            return rest.Substring(0, comma);
        }

        return rest;
    }

    private static bool IsAfterRate(string rest, int comma)
    {
        int digit = comma - 1;
        while (digit >= 0 && rest[digit] is >= '0' and <= '9') digit--;
        return digit >= 0 && digit < comma - 1 && rest[digit] == ':';
    }

    private static string? ParseHost(string text, string rest, LinkKind kind, string form, ref LinkUrl? url)
    {
        if (rest.StartsWith("//", StringComparison.Ordinal))
            return Wrong(text, "there are no slashes after the scheme", form);
        bool bracketed = rest.StartsWith('[');
        int hostEnd = bracketed ? rest.IndexOf(']') + 1 : rest.LastIndexOf(':');
        if (bracketed && hostEnd == 0) return Wrong(text, "the bracket around the address is not closed", form);
        if (hostEnd < 0 || hostEnd == rest.Length) return Wrong(text, "the port is missing", form);
        if (rest[hostEnd] != ':')
            return Wrong(text, "after the closing bracket a colon and the port must follow", form);

        string host = bracketed ? rest.Substring(1, hostEnd - 2) : rest.Substring(0, hostEnd);
        if (HostFault(host, bracketed) is { } hostFault) return Wrong(text, hostFault, form);

        string portText = rest.Substring(hostEnd + 1);
        if (portText.Length == 0) return Wrong(text, "the port is missing", form);
        if (!TryParseWhole(portText, out int port) || port is < 1 or > 65535)
            return Wrong(text, $"the port '{portText}' is not a number from 1 to 65535", form);

        url = LinkUrl.ForHost(kind, host, port);
        return null;
    }

    private static string? HostFault(string host, bool bracketed)
    {
        if (host.Length == 0) return "the host is missing";
        if (bracketed
            && !(IPAddress.TryParse(host, out IPAddress? address)
                && address.AddressFamily == AddressFamily.InterNetworkV6))
            return $"'{host}' in brackets is not an IPv6 address";
        if (!bracketed && host.Contains(':'))
            return $"the host '{host}' holds a colon (an IPv6 address is written in brackets, [::1])";
        foreach (char c in host)
        {
            if (char.IsWhiteSpace(c) || c is '/' or '?' or '[' or ']') return $"the host '{host}' holds a '{c}'";
        }

        return null;
    }

    private static string? ParseSerial(string text, string rest, ref LinkUrl? url)
    {
        // The last colon: paths under /dev/serial/by-path hold colons of their own.
        int colon = rest.LastIndexOf(':');
        if (rest.Length == 0 || colon == 0) return Wrong(text, "the device is missing", SerialForm);
        if (colon < 0 || colon == rest.Length - 1) return Wrong(text, "the baud rate is missing", SerialForm);

        string baudText = rest.Substring(colon + 1);
        if (!TryParseWhole(baudText, out int baudRate) || baudRate < 1)
            return Wrong(text, $"the baud rate '{baudText}' is not a positive whole number", SerialForm);
        string device = rest.Substring(0, colon);
        if (device.Contains('\0'))
            return Wrong(text.Replace("\0", "\\0"), "the device holds a zero character", SerialForm);

        url = LinkUrl.ForSerial(device, baudRate);
        return null;
    }

    private static string? ParseFile(string text, string rest, ref LinkUrl? url)
    {
        string path = rest;
        double speed = 1;
        if (TrySplitOption(rest, out string beforeOption, out string name, out string? value))
        {
            path = beforeOption;
            if (!string.Equals(name, SpeedOption, StringComparison.OrdinalIgnoreCase))
                return Wrong(text, $"the option '{name}' is unknown", FileForm);
            if (!TryParseSpeed(value, out speed))
                return Wrong(text, $"the speed '{value}' is not a positive number or max", FileForm);
            if (speed > MaxSpeed && !double.IsInfinity(speed))
                return Wrong(text, $"the speed '{value}' is above 1000000; that is max", FileForm);
        }

        if (path.Length == 0) return Wrong(text, "the file is missing", FileForm);
        url = LinkUrl.ForFile(path, speed);
        return null;
    }

    // What stands after the last question mark is an option if it reads name=value, or is the one name that we know;
    // else it is part of the path.
    private static bool TrySplitOption(string rest, out string path, out string name, out string? value)
    {
        int mark = rest.LastIndexOf('?');
        string option = rest.Substring(mark + 1);
        int equals = option.IndexOf('=');
        path = mark < 0 ? rest : rest.Substring(0, mark);
        name = equals < 0 ? option : option.Substring(0, equals);
        value = equals < 0 ? "" : option.Substring(equals + 1);
        if (mark < 0) return false;
        return equals < 0 ? string.Equals(name, SpeedOption, StringComparison.OrdinalIgnoreCase) : IsOptionName(name);
    }

    private static bool IsOptionName(string name)
    {
        foreach (char c in name)
        {
            if (!char.IsLetterOrDigit(c) && c is not ('-' or '_')) return false;
        }

        return name.Length > 0;
    }

    private static bool TryParseSpeed(string? text, out double speed)
    {
        speed = double.PositiveInfinity;
        if (string.Equals(text, "max", StringComparison.OrdinalIgnoreCase)) return true;
        return double.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out speed)
            && speed > 0 && !double.IsInfinity(speed);
    }

    private static bool TryParseWhole(string text, out int number) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out number);

    private static string Wrong(string text, string fault, string form) => $"link '{text}': {fault}; write {form}";
}
