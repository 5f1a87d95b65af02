using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace Rabit.Links;

/// <summary>Reads the options behind the URL of a link: <c>name=value</c> and bare names, parted by commas.</summary>
internal static class LinkSettingsParser
{
    public const string Name = "name";

    private const double MaxMilliseconds = 60_000;
    private const double MaxSeconds = 3600;
    private const int MaxMessageId = 0xFF_FFFF;

    private static readonly string[] Flags = ["optional", "listen-only", "receive-only"];

    private static readonly string[] Names =
    [
        Name, "rate", "flush", "hold", "idle", "keepalive", "position", "key", "allow", "allow-in", "allow-out", "deny",
        "deny-in", "deny-out", .. Flags,
    ];

    /// <summary>Whether text behind a comma is an option that is known, whatever its value.</summary>
    public static bool IsKnown(string option) => Names.Contains(NameOf(option), StringComparer.OrdinalIgnoreCase);

    /// <summary>Reads them.</summary>
    /// <param name="text">What stands behind the first comma.</param>
    /// <param name="kind">Some are for one kind only.</param>
    /// <param name="settings">What they say.</param>
    /// <returns>What is wrong; null for nothing.</returns>
    public static string? Parse(string text, LinkKind kind, out LinkSettings settings)
    {
        settings = LinkSettings.None;
        var values = new Dictionary<string, string>(StringComparer.OrdinalIgnoreCase);
        foreach (string option in text.Split(','))
        {
            string name = NameOf(option);
            bool isFlag = Flags.Contains(name, StringComparer.OrdinalIgnoreCase);
            if (!IsKnown(option))
                return $"the option '{name}' is unknown; there are {string.Join(", ", Names)}";
            if (isFlag != (name.Length == option.Length))
                return isFlag ? $"the option '{name}' has no value" : $"the option '{name}' needs a value, {name}=...";
            if (values.ContainsKey(name)) return $"the option '{name}' is given twice";
            values.Add(name, isFlag ? "" : option.Substring(name.Length + 1));
        }

        return FaultOfKind(values, kind) ?? Read(values, out settings);
    }

    private static string NameOf(string option)
    {
        int equals = option.IndexOf('=');
        return equals < 0 ? option : option.Substring(0, equals);
    }

    private static string? FaultOfKind(Dictionary<string, string> values, LinkKind kind)
    {
        if (values.ContainsKey("idle") && kind != LinkKind.UdpListen) return "the option 'idle' is for udpin only";
        if (values.ContainsKey("keepalive") && kind != LinkKind.UdpSend)
            return "the option 'keepalive' is for udpout only";
        if (kind == LinkKind.RecordedFile && values.Keys.FirstOrDefault(n => !Is(n, Name)) is { } other)
            return $"the option '{other}' is for live links only";
        if (values.ContainsKey("listen-only") && values.ContainsKey("receive-only"))
            return "with 'listen-only' and 'receive-only' together nothing would pass";
        if (values.ContainsKey("allow") && (values.ContainsKey("allow-in") || values.ContainsKey("allow-out")))
            return "the option 'allow' is both 'allow-in' and 'allow-out'; give it or those";
        if (values.ContainsKey("deny") && (values.ContainsKey("deny-in") || values.ContainsKey("deny-out")))
            return "the option 'deny' is both 'deny-in' and 'deny-out'; give it or those";
        return null;
    }

    private static string? Read(Dictionary<string, string> values, out LinkSettings settings)
    {
        string? fault = null;
        settings = new LinkSettings
        {
            Name = Text(values, Name, ref fault),
            BytesPerSecond = (int?)Number(values, "rate", 280, 100_000_000, isWhole: true, ref fault),
            FlushAfter = Time(values, "flush", 1, MaxMilliseconds, 1, ref fault),
            HoldTime = Time(values, "hold", 1, 1000, 1, ref fault),
            IdleTime = Time(values, "idle", 1, MaxSeconds, 1000, ref fault),
            KeepAlive = Time(values, "keepalive", 1, MaxSeconds, 1000, ref fault),
            IsOptional = values.ContainsKey("optional"),
            IsListenOnly = values.ContainsKey("listen-only"),
            IsReceiveOnly = values.ContainsKey("receive-only"),
            SendsPosition = YesOrNo(values, "position", ref fault),
            KeyFile = Text(values, "key", ref fault),
            AllowIn = Filter(values, "allow-in", "allow", ref fault),
            AllowOut = Filter(values, "allow-out", "allow", ref fault),
            DenyIn = Filter(values, "deny-in", "deny", ref fault),
            DenyOut = Filter(values, "deny-out", "deny", ref fault),
        };
        return fault;
    }

    private static string? Text(Dictionary<string, string> values, string name, ref string? fault)
    {
        if (!values.TryGetValue(name, out string? value)) return null;
        if (string.IsNullOrWhiteSpace(value)) fault ??= $"the option '{name}' is empty";
        return value;
    }

    private static TimeSpan? Time(
        Dictionary<string, string> values, string name, double least, double most, double milliseconds,
        ref string? fault)
        => Number(values, name, least, most, isWhole: false, ref fault) is { } number
            ? new TimeSpan((long)(number * milliseconds * TimeSpan.TicksPerMillisecond))
            : null;

    private static double? Number(
        Dictionary<string, string> values, string name, double least, double most, bool isWhole, ref string? fault)
    {
        if (!values.TryGetValue(name, out string? value)) return null;
        bool isNumber = double.TryParse(
            value, isWhole ? NumberStyles.None : NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture,
            out double number);
        if (isNumber && number >= least && number <= most) return number;
        fault ??= FormattableString.Invariant($"{name}={value} is not a number from {least} to {most}");
        return null;
    }

    private static bool YesOrNo(Dictionary<string, string> values, string name, ref string? fault)
    {
        if (!values.TryGetValue(name, out string? value)) return true;
        if (!Is(value, "yes") && !Is(value, "no")) fault ??= $"{name}={value} is neither yes nor no";
        return !Is(value, "no");
    }

    // ID+ID+@SYSTEM+@SYSTEM/COMPONENT
    private static LinkFilter? Filter(
        Dictionary<string, string> values, string name, string both, ref string? fault)
    {
        if (!values.TryGetValue(name, out string? value) && !values.TryGetValue(both, out value)) return null;
        var ids = new List<int>();
        var senders = new List<(byte, byte?)>();
        foreach (string item in value.Split('+'))
        {
            if (item.Length > 0 && item[0] == '@' && TryParseSender(item.Substring(1), out (byte, byte?) sender))
                senders.Add(sender);
            else if (TryParse(item, MaxMessageId, out int id))
                ids.Add(id);
            else
                fault ??= $"'{item}' of {(values.ContainsKey(name) ? name : both)}={value} is neither a message id, for "
                    + "example 33, nor a sender, @SYSTEM or @SYSTEM/COMPONENT";
        }

        return new LinkFilter(ids, senders);
    }

    private static bool TryParseSender(string text, out (byte SystemId, byte? ComponentId) sender)
    {
        sender = default;
        string[] parts = text.Split('/');
        if (parts.Length > 2 || !TryParse(parts[0], byte.MaxValue, out int system)) return false;
        int component = 0;
        if (parts.Length == 2 && !TryParse(parts[1], byte.MaxValue, out component)) return false;
        sender = ((byte)system, parts.Length == 2 ? (byte)component : null);
        return true;
    }

    private static bool TryParse(string text, int most, out int number)
        => int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out number) && number <= most;

    private static bool Is(string text, string other) => string.Equals(text, other, StringComparison.OrdinalIgnoreCase);
}
