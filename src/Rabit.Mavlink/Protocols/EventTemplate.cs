using System;
using System.Collections.Generic;
using System.Text;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink.Protocols;

/// <summary>
/// Fills the texts of events (libevents, "Message and description"): <c>{1}</c>, <c>{2:.1m}</c> for arguments, '\'
/// before a character that is meant as it is, tags for addresses, parameters and profiles. What is no valid format
/// stays as it is written.
/// </summary>
internal sealed class EventTemplate
{
    private const string Profile = "normal";   // the other one is "dev", for developers
    private const int MaxDecimals = 15;

    private readonly IReadOnlyList<EventArgumentType> _types;
    private readonly int[] _offsets;
    private readonly Event _message;

    public EventTemplate(IReadOnlyList<EventArgumentType> types, in Event message)
    {
        (_types, _message) = (types, message);
        _offsets = new int[types.Count];
        int offset = 0;
        for (int i = 0; i < types.Count; i++)
        {
            _offsets[i] = offset;
            offset += types[i].Size;
        }
    }

    public string Fill(string template)
    {
        var text = new StringBuilder();
        Fill(text, template, 0, template.Length, isInTag: false);
        return text.ToString().Trim();
    }

    private void Fill(StringBuilder text, string template, int start, int end, bool isInTag)
    {
        for (int i = start; i < end;)
        {
            int next = template[i] switch
            {
                '\\' when i + 1 < end => AppendEscaped(text, template[i + 1], i),
                '{' => AppendArgument(text, template, i, end),
                '<' => AppendTag(text, template, i, end, isInTag),
                _ => i,
            };
            if (next == i)
                text.Append(template[i++]);
            else
                i = next;
        }
    }

    private static int AppendEscaped(StringBuilder text, char character, int at)
    {
        text.Append(character);
        return at + 2;
    }

    // Where it goes on; the same place where this is no argument.
    private int AppendArgument(StringBuilder text, string template, int at, int end)
    {
        int close = template.IndexOf('}', at, end - at);
        int i = at + 1;
        if (close < 0 || !TryReadNumber(template, ref i, close, out int argument)
            || argument < 1 || argument > _types.Count)
            return at;
        int decimals = -1;
        if (template[i] == ':' && template[i + 1] == '.')
        {
            i += 2;
            if (!TryReadNumber(template, ref i, close, out decimals) || decimals > MaxDecimals)
                return at;
        }
        else if (template[i] == ':')
        {
            i++;
        }

        if (UnitOf(template.Substring(i, close - i)) is not { } unit)
            return at;
        EventArgumentType type = _types[argument - 1];
        int offset = _offsets[argument - 1];
        if (offset + type.Size <= MavlinkEvent.ArgumentBytes)
            type.Append(text, _message.Arguments, offset, decimals);
        else
            text.Append('?');
        text.Append(unit);
        return close + 1;
    }

    private static string? UnitOf(string name) => name switch
    {
        "" => string.Empty,
        "m" or "m_v" => " m",
        "m^2" => " m²",
        "m/s" => " m/s",
        "C" => " °C",
        _ => null,
    };

    private static bool TryReadNumber(string template, ref int index, int end, out int number)
    {
        number = 0;
        int start = index;
        while (index < end && template[index] is >= '0' and <= '9' && number < 1000)
            number = (10 * number) + (template[index++] - '0');
        return index > start;
    }

    // Tags are not nested, but for an address or a parameter in a profile.
    private int AppendTag(StringBuilder text, string template, int at, int end, bool isInTag)
    {
        int nameEnd = at + 1;
        while (nameEnd < end && template[nameEnd] is >= 'a' and <= 'z')
            nameEnd++;
        int headEnd = template.IndexOf('>', nameEnd, end - nameEnd);
        if (nameEnd == at + 1 || headEnd < 0)
            return at;
        string name = template.Substring(at + 1, nameEnd - at - 1);
        string attribute = AttributeOf(template.Substring(nameEnd, headEnd - nameEnd));
        string closing = "</" + name + ">";
        int close = template.IndexOf(closing, headEnd, end - headEnd, StringComparison.Ordinal);
        if (close < 0)
            return at;
        string content = template.Substring(headEnd + 1, close - headEnd - 1);
        if (name == "a")
            text.Append(attribute.Length == 0 || attribute == content ? content : content + " (" + attribute + ")");
        else if (name == "param")
            text.Append(content);
        else if (name == "profile" && !isInTag && IsShown(attribute))
            Fill(text, template, headEnd + 1, close, isInTag: true);
        return close + closing.Length;
    }

    private static string AttributeOf(string head)
    {
        int open = head.IndexOf('"');
        int close = open < 0 ? -1 : head.IndexOf('"', open + 1);
        return close < 0 ? string.Empty : head.Substring(open + 1, close - open - 1);
    }

    private static bool IsShown(string profile)
        => profile.Length > 0 && profile[0] == '!' ? profile.Substring(1) != Profile : profile == Profile;
}
