using System;
using System.Collections.Generic;
using System.Text;

namespace Rabit.Mavlink;

/// <summary>
/// A message as its definition has it: for tools that show any message without knowing it at compile time. Found by
/// <see cref="MavlinkDialect.FindDefinition(int)"/>. Immutable, safe from any thread.
/// </summary>
/// <example>
/// <code>
/// static void Print(in MavlinkFrame frame)
/// {
///     if (MavlinkDialect.All.FindDefinition(frame.MessageId) is not { } definition)
///         return;
///     foreach (MavlinkFieldDefinition field in definition.Fields)
///         Console.WriteLine($"{field.Name} = {field.GetValue(frame)} {field.Units}");
/// }
/// </code>
/// </example>
public sealed class MavlinkMessageDefinition
{
    internal MavlinkMessageDefinition(in MavlinkMessageInfo info, IReadOnlyList<MavlinkFieldDefinition> fields)
    {
        Info = info;
        Fields = fields;
    }

    /// <summary>Id, name, checksum byte, lengths.</summary>
    public MavlinkMessageInfo Info { get; }

    /// <summary>Its fields in the order of the definition, which is not that of the wire.</summary>
    public IReadOnlyList<MavlinkFieldDefinition> Fields { get; }

    /// <summary>Finds a field.</summary>
    /// <param name="name">Name as the definition writes it; case does not count.</param>
    /// <returns>The field, or null where there is none of that name.</returns>
    public MavlinkFieldDefinition? FindField(string name)
    {
        foreach (MavlinkFieldDefinition field in Fields)
        {
            if (string.Equals(field.Name, name, StringComparison.OrdinalIgnoreCase))
                return field;
        }

        return null;
    }

    /// <summary>
    /// Writes the message as a person reads it, on one line: <c>ATTITUDE time_boot_ms=1200 ms, roll=0.5 rad, ...</c>
    /// </summary>
    /// <param name="text">Where to write.</param>
    /// <param name="frame">A frame that carries the message.</param>
    /// <exception cref="ArgumentException">The frame carries another message.</exception>
    public void AppendTo(StringBuilder text, in MavlinkFrame frame)
    {
        if (text is null)
            throw new ArgumentNullException(nameof(text));
        text.Append(Info.Name);
        string separator = " ";
        foreach (MavlinkFieldDefinition field in Fields)
        {
            text.Append(separator).Append(field.Name).Append('=');
            field.AppendTo(text, frame);
            if (field.Units is not null)
                text.Append(' ').Append(field.Units);
            separator = ", ";
        }
    }
}
