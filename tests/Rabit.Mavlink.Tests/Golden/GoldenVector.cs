using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;

namespace Rabit.Mavlink.Tests.Golden;

/// <summary>
/// One line of golden.jsonl: a message with its field values, and the frames that an independent library made of it.
/// </summary>
internal sealed class GoldenVector(JsonElement line)
{
    /// <summary>MAVLink 2: magic, length, two flag bytes, sequence, system, component, three bytes of id.</summary>
    private const int V2HeaderLength = 10;

    public string Name { get; } = line.GetProperty("name").GetString()!;

    public int Id { get; } = line.GetProperty("id").GetInt32();

    /// <summary>zero, typical or max.</summary>
    public string Case { get; } = line.GetProperty("case").GetString()!;

    public byte CrcExtra { get; } = line.GetProperty("crc_extra").GetByte();

    /// <summary>Payload bytes without extensions, which every MAVLink 1 frame has.</summary>
    public int MinLength { get; } = line.GetProperty("min_len").GetInt32();

    /// <summary>Payload bytes with the extensions that the making library knew; ours may know more.</summary>
    public int MaxLength { get; } = line.GetProperty("max_len").GetInt32();

    /// <summary>
    /// Values by field name, in the order of the definition. 64-bit integers, NaN and infinities are strings.
    /// </summary>
    public IReadOnlyList<KeyValuePair<string, JsonElement>> Fields { get; } =
        line.GetProperty("fields").EnumerateObject()
            .Select(field => new KeyValuePair<string, JsonElement>(field.Name, field.Value)).ToList();

    public byte SystemId { get; } = line.GetProperty("sysid").GetByte();

    public byte ComponentId { get; } = line.GetProperty("compid").GetByte();

    public byte Sequence { get; } = line.GetProperty("seq").GetByte();

    /// <summary>The MAVLink 1 frame; null for ids above 255.</summary>
    public byte[]? V1 { get; } = line.GetProperty("v1").GetString() is { } hex ? TestData.FromHex(hex) : null;

    /// <summary>The unsigned MAVLink 2 frame, its trailing zeros cut.</summary>
    public byte[] V2 { get; } = TestData.FromHex(line.GetProperty("v2").GetString()!);

    /// <summary>The signed MAVLink 2 frame.</summary>
    public byte[] V2Signed { get; } = TestData.FromHex(line.GetProperty("v2signed").GetString()!);

    /// <summary>Key, link id and time stamp of the signature.</summary>
    public JsonElement Signing { get; } = line.GetProperty("signing");

    /// <summary>The payload of <see cref="V2"/>, filled up with zeros.</summary>
    public byte[] Payload(int length)
    {
        var payload = new byte[length];
        Array.Copy(V2, V2HeaderLength, payload, 0, V2[1]);
        return payload;
    }

    public override string ToString() => $"{Name} {Case}";
}
