using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Generator.Naming;

namespace Rabit.Mavlink.Generator.Emitting;

/// <summary>
/// Packs the definitions of a dialect into one string literal, which <c>DefinitionData</c> of the package reads: names,
/// lengths and checksum bytes first, then fields, shared texts and enums, which are only unpacked when asked for.
/// Bytes, two in a character; numbers of seven bits a byte, the lowest first; texts in UTF-8 with their length in
/// front.
/// </summary>
internal sealed class DefinitionDataWriter
{
    /// <summary>Raised with every change of the format; the package refuses another one.</summary>
    private const int FormatVersion = 1;

    // In the order of MavlinkFieldType.
    private static readonly string[] Types =
    [
        "char", "int8_t", "uint8_t", "int16_t", "uint16_t", "int32_t", "uint32_t", "int64_t", "uint64_t", "float",
        "double"
    ];

    private readonly List<byte> _bytes = [];
    private readonly Dictionary<string, int> _texts;
    private readonly List<string> _textList;

    private DefinitionDataWriter(Dictionary<string, int> texts, List<string> textList)
    {
        _texts = texts;
        _textList = textList;
    }

    /// <summary>The literal, quotes included.</summary>
    /// <param name="dialect">The whole dialect.</param>
    /// <param name="names">Which of its types are its own.</param>
    /// <param name="parts">The files that can be asked for by themselves.</param>
    public static string Write(Dialect dialect, GeneratedTypeNames names, IReadOnlyCollection<DialectPart> parts)
    {
        var writer = new DefinitionDataWriter([], []);
        writer.WriteAll(dialect, names, parts);
        return writer.Literal();
    }

    private void WriteAll(Dialect dialect, GeneratedTypeNames names, IReadOnlyCollection<DialectPart> parts)
    {
        List<string> files = dialect.Parts.Select(part => part.File).Distinct(System.StringComparer.Ordinal).ToList();
        Number(FormatVersion);
        Text(dialect.Name);
        Number(parts.Count);
        foreach (DialectPart part in parts)
        {
            Text(part.File);
            Increasing(part.Files.Select(file => files.IndexOf(file)).OrderBy(index => index).ToList());
        }

        Increasing(dialect.Messages.Where(message => !names.IsOwn(message)).Select(message => message.Id).ToList());
        Number(names.OwnMessages.Count);
        int previous = 0;
        foreach (MessageDefinition message in names.OwnMessages)
        {
            WriteMessage(message, previous, files.IndexOf(message.File));
            previous = message.Id;
        }

        DefinitionDataWriter enums = Inner();
        foreach (EnumDefinition definition in names.OwnEnums)
        {
            enums.Number(Index(definition.Name));
            DefinitionDataWriter content = Inner();
            content.WriteEnum(definition);
            enums.Append(content);
        }

        Number(_textList.Count);
        foreach (string text in _textList)
            Text(text);
        Number(names.OwnEnums.Count);
        _bytes.AddRange(enums._bytes);
    }

    private void WriteMessage(MessageDefinition message, int previousId, int file)
    {
        Number(message.Id - previousId);
        Text(message.Name);
        _bytes.Add(message.CrcExtra);
        _bytes.Add((byte)message.MinLength);
        _bytes.Add((byte)message.MaxLength);
        Number(message.AddressOffset("target_system") + 1);
        Number(message.AddressOffset("target_component") + 1);
        Number(file < 0 ? 0 : file);
        DefinitionDataWriter fields = Inner();
        fields.Number(message.Fields.Count);
        foreach (FieldDefinition field in message.Fields)
            fields.WriteField(field, message.OffsetOf(field));
        Append(fields);
    }

    private void WriteField(FieldDefinition field, int offset)
    {
        string?[] texts = [field.Units, field.Enum, field.Invalid, field.Multiplier, field.MinValue, field.MaxValue];
        Number(Index(field.Name));
        _bytes.Add((byte)(System.Array.IndexOf(Types, field.Type.Name)
            | (field.IsExtension ? 0x10 : 0) | (field.IsInstance ? 0x20 : 0) | (field.ArrayLength != 0 ? 0x40 : 0)));
        _bytes.Add((byte)texts.Select((text, bit) => text is null ? 0 : 1 << bit).Sum());
        _bytes.Add((byte)offset);
        if (field.ArrayLength != 0)
            _bytes.Add((byte)field.ArrayLength);
        foreach (string? text in texts)
        {
            if (text is not null)
                Number(Index(text));
        }
    }

    // A name is what it shares with the one before (the first: with the enum's), and its rest; a value is the step from
    // the one before.
    private void WriteEnum(EnumDefinition definition)
    {
        _bytes.Add((byte)(definition.IsBitmask ? 1 : 0));
        Number(definition.Entries.Count);
        string previousName = definition.Name;
        long previous = 0;
        foreach (EnumEntry entry in definition.Entries)
        {
            int shared = previousName.Zip(entry.Name, (left, right) => left == right)
                .TakeWhile(isSame => isSame).Count();
            Number(shared);
            Text(entry.Name.Substring(shared));
            previousName = entry.Name;
            long value = entry.Value < 0 ? (long)entry.Value : unchecked((long)(ulong)entry.Value);
            long step = unchecked(value - previous);
            Number(unchecked((ulong)((step << 1) ^ (step >> 63))));
            previous = value;
        }
    }

    private DefinitionDataWriter Inner() => new(_texts, _textList);

    private void Append(DefinitionDataWriter inner)
    {
        Number(inner._bytes.Count);
        _bytes.AddRange(inner._bytes);
    }

    private int Index(string text)
    {
        if (!_texts.TryGetValue(text, out int index))
        {
            _texts.Add(text, index = _textList.Count);
            _textList.Add(text);
        }

        return index;
    }

    private void Increasing(List<int> numbers)
    {
        Number(numbers.Count);
        int previous = 0;
        foreach (int number in numbers)
        {
            Number(number - previous);
            previous = number;
        }
    }

    private void Number(int number) => Number((ulong)number);

    private void Number(ulong number)
    {
        for (; number >= 0x80; number >>= 7)
            _bytes.Add((byte)(number | 0x80));
        _bytes.Add((byte)number);
    }

    private void Text(string text)
    {
        byte[] bytes = Encoding.UTF8.GetBytes(text);
        Number(bytes.Length);
        _bytes.AddRange(bytes);
    }

    private string Literal()
    {
        var literal = new StringBuilder("\"", (_bytes.Count * 3) + 8);
        for (int index = 0; index < _bytes.Count; index += 2)
        {
            int pair = _bytes[index] | ((index + 1 < _bytes.Count ? _bytes[index + 1] : 0) << 8);
            literal.Append("\\u").Append(pair.ToString("x4", CultureInfo.InvariantCulture));
        }

        return literal.Append('"').ToString();
    }
}
