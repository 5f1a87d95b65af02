using System;
using System.Collections.Generic;
using System.IO;
using System.Text.Json;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

/// <summary>
/// The texts of a component's events, from its metadata: the file all_events.json of libevents, which PX4's builds make
/// (MAVLink guide, "Component Metadata Protocol", type EVENTS). Immutable, safe from any thread.
/// </summary>
/// <example>
/// <code>
/// static string TextOf(MavlinkEventCatalog catalog, MavlinkEvent happened)
///     => catalog.Find(happened.Id)?.MessageOf(happened) ?? happened.ToString();
/// </code>
/// </example>
public sealed class MavlinkEventCatalog
{
    // Far more than any build has: a device that is given by mistake has no end.
    private const int MaxBytes = 32_000_000;

    private readonly Dictionary<uint, MavlinkEventDefinition> _definitions;

    private MavlinkEventCatalog(Dictionary<uint, MavlinkEventDefinition> definitions) => _definitions = definitions;

    /// <summary>How many events there are texts of.</summary>
    public int Count => _definitions.Count;

    /// <summary>Reads the file of an autopilot's build.</summary>
    /// <param name="json">Its content.</param>
    /// <exception cref="FormatException">It is none; the text says what is wrong, and where.</exception>
    public static MavlinkEventCatalog Parse(ReadOnlyMemory<byte> json)
    {
        if (IsCompressed(json.Span))
            throw new FormatException("the file is compressed with xz; it must be unpacked first");
        try
        {
            using var document = JsonDocument.Parse(json);
            return new MavlinkEventCatalog(new EventCatalogReader(document.RootElement).Read());
        }
        catch (Exception e) when (e is JsonException or InvalidOperationException)
        {
            // The latter: texts that are none, such as half of a surrogate pair.
            throw new FormatException("no JSON: " + e.Message, e);
        }
    }

    /// <summary>Reads the file of an autopilot's build to its end.</summary>
    /// <param name="file">The file; stays open.</param>
    /// <exception cref="FormatException">It is none; the text says what is wrong, and where.</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static MavlinkEventCatalog Read(Stream file)
    {
        if (file is null)
            throw new ArgumentNullException(nameof(file));
        using var json = new MemoryStream();
        var part = new byte[81_920];
        for (int count; (count = file.Read(part, 0, part.Length)) > 0;)
        {
            if (json.Length + count > MaxBytes)
                throw new FormatException($"it has more than {MaxBytes} bytes");
            json.Write(part, 0, count);
        }

        return Parse(json.ToArray());
    }

    /// <summary>What is known of an event.</summary>
    /// <param name="id">Its number.</param>
    /// <returns>Null where nothing is.</returns>
    public MavlinkEventDefinition? Find(uint id)
        => _definitions.TryGetValue(id, out MavlinkEventDefinition? found) ? found : null;

    // The first bytes of every .xz file.
    internal static bool IsCompressed(ReadOnlySpan<byte> file)
        => file.Length >= 6 && file[0] == 0xFD && file[1] == '7' && file[2] == 'z' && file[3] == 'X' && file[4] == 'Z'
            && file[5] == 0;
}
