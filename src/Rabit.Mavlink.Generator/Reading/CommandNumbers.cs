using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>
/// Compares the commands of a dialect with those of the package that it does not include. Numbers of commands are one
/// space for all vehicles: a command that ArduPilot takes for another one is dangerous, even where the dialect does
/// not know ArduPilot's.
/// </summary>
public static class CommandNumbers
{
    private const string Commands = "MAV_CMD";

    /// <summary>Finds commands whose numbers the package gives to others.</summary>
    /// <param name="dialect">The dialect.</param>
    /// <param name="package">All definitions of the package.</param>
    /// <returns>A warning for each, at the place of its entry.</returns>
    public static IEnumerable<DialectFault> Check(Dialect dialect, Dialect package)
    {
        ILookup<decimal, EnumEntry> known = EntriesOf(package).ToLookup(entry => entry.Value);
        foreach (EnumEntry entry in EntriesOf(dialect))
        {
            EnumEntry? other = known[entry.Value].FirstOrDefault();
            if (other is null || entry.Place is null || string.Equals(other.Name, entry.Name, StringComparison.Ordinal))
                continue;
            yield return new DialectFault(
                DialectFaultKind.CommandOfPackage, entry.Place.Path, entry.Place.Line, entry.Place.Column,
                $"{entry.Name} of enum {Commands} is {entry.Value}, "
                + $"which is {other.Name} in {other.Place?.FileName} of the package; a vehicle that knows that one "
                + "would carry it out.");
        }
    }

    private static IEnumerable<EnumEntry> EntriesOf(Dialect dialect) =>
        dialect.Enums.Where(definition => definition.Name == Commands).SelectMany(definition => definition.Entries);
}
