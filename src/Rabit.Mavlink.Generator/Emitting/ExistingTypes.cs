using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Generator.Naming;

namespace Rabit.Mavlink.Generator.Emitting;

/// <summary>
/// The types that the package has already, so that a user's dialect need not have them again. Definitions are compared,
/// not file names: a project that keeps a copy of common.xml beside a file of its own gets the package's types where
/// the copy says the same.
/// </summary>
public sealed class ExistingTypes
{
    private readonly Dictionary<int, MessageDefinition> _messages;
    private readonly Dictionary<string, EnumDefinition> _enums;
    private readonly HashSet<ArrayType> _arrays;
    private readonly GeneratedTypeNames _names;
    private readonly Dialect _dialect;

    /// <summary>Takes the dialect from which the package's types were generated.</summary>
    /// <param name="dialect">The definitions of the package.</param>
    /// <param name="namespace">The namespace of its types.</param>
    public ExistingTypes(Dialect dialect, string @namespace)
    {
        _dialect = dialect ?? throw new ArgumentNullException(nameof(dialect));
        Namespace = @namespace ?? throw new ArgumentNullException(nameof(@namespace));
        _messages = dialect.Messages.ToDictionary(message => message.Id);
        _enums = dialect.Enums.ToDictionary(definition => definition.Name, StringComparer.Ordinal);
        _arrays = [.. ArrayType.AllOf(dialect.Messages)];
        _names = new GeneratedTypeNames(dialect);
    }

    /// <summary>The namespace of the package's types.</summary>
    public string Namespace { get; }

    /// <summary>The package's struct for a message, if it has the same fields in the same places.</summary>
    internal string? Find(MessageDefinition message) =>
        _messages.TryGetValue(message.Id, out MessageDefinition? known) && known.HasSameWireForm(message)
            ? Qualified(_names.OfMessage(known))
            : null;

    /// <summary>
    /// The package's enum, if it has all the entries and can hold all the values of the given fields.
    /// </summary>
    internal string? Find(EnumDefinition definition, IEnumerable<WireType> fieldTypes)
    {
        if (!_enums.TryGetValue(definition.Name, out EnumDefinition? known) || known.IsBitmask != definition.IsBitmask)
            return null;
        HashSet<(string Name, decimal Value)> entries = [.. known.Entries.Select(entry => (entry.Name, entry.Value))];
        WireType underlying = EnumUnderlyingType.Of(known, _dialect);
        bool isSame = definition.Entries.All(entry => entries.Contains((entry.Name, entry.Value)))
            && fieldTypes.All(type => type.Min >= underlying.Min && type.Max <= underlying.Max);
        return isSame ? Qualified(_names.OfEnum(known.Name)) : null;
    }

    /// <summary>
    /// The package's enum, if a dialect only adds entries to it: they have an entry in common, agree in all that both
    /// have, and the package's enum can hold all the values of the given fields. A number that the package's enum gives
    /// to an entry which the dialect does not include is no hindrance; it then has two names.
    /// </summary>
    internal string? FindExtended(EnumDefinition definition, IEnumerable<WireType> fieldTypes)
    {
        if (!_enums.TryGetValue(definition.Name, out EnumDefinition? known) || known.IsBitmask != definition.IsBitmask)
            return null;
        Dictionary<string, decimal> values =
            known.Entries.ToDictionary(entry => entry.Name, entry => entry.Value, StringComparer.Ordinal);
        List<EnumEntry> shared = definition.Entries.Where(entry => values.ContainsKey(entry.Name)).ToList();
        WireType underlying = EnumUnderlyingType.Of(known, _dialect);
        bool isExtended = shared.Count != 0 && shared.All(entry => values[entry.Name] == entry.Value)
            && definition.Entries.All(entry => entry.Value >= underlying.Min && entry.Value <= underlying.Max)
            && fieldTypes.All(type => type.Min >= underlying.Min && type.Max <= underlying.Max);
        return isExtended ? Qualified(_names.OfEnum(known.Name)) : null;
    }

    /// <summary>Whether the package's enum of this name has an entry of this name.</summary>
    internal bool HasEntry(string enumName, string entryName) =>
        _enums.TryGetValue(enumName, out EnumDefinition? known)
        && known.Entries.Any(entry => string.Equals(entry.Name, entryName, StringComparison.Ordinal));

    /// <summary>The package's value type for an array.</summary>
    internal string? Find(ArrayType array) => _arrays.Contains(array) ? Qualified(array.Name) : null;

    private string Qualified(string name) => $"global::{Namespace}.{name}";
}
