using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Mavlink.Generator.Emitting;
using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Naming;

/// <summary>
/// Names of the types of a dialect. Enums and messages are their names in the definition, in Pascal case. An enum whose
/// name is taken gets Enum appended, a message whose name is taken Message, and if that is taken too its id. What the
/// package has already keeps its name there; only the rest is the dialect's own. Entries that it adds to an enum of the
/// package are in a class that is called after the dialect and the enum.
/// </summary>
internal sealed class GeneratedTypeNames
{
    private readonly Dictionary<string, string> _enums = new(StringComparer.Ordinal);
    private readonly Dictionary<int, string> _messages = [];
    private readonly Dictionary<ArrayType, string> _arrays = [];
    private readonly Dictionary<string, string> _addedEntries = new(StringComparer.Ordinal);
    private readonly ExistingTypes? _existing;
    private readonly HashSet<int> _ownIds;

    // What generated code itself refers to by its bare name.
    private readonly HashSet<string> _used = new(StringComparer.OrdinalIgnoreCase)
    {
        "MavlinkPayload", "MavlinkArray", "MavlinkText", "MavlinkDialect", "MavlinkDialectData", "IMavlinkMessage",
    };

    public GeneratedTypeNames(Dialect dialect, ExistingTypes? existing = null)
    {
        _existing = existing;
        OwnMessages = dialect.Messages.Where(message => !Exists(_messages, message.Id, existing?.Find(message)))
            .ToList();
        _ownIds = [.. OwnMessages.Select(message => message.Id)];
        OwnArrays = ArrayType.AllOf(OwnMessages)
            .Where(array => !Exists(_arrays, array, existing?.Find(array))).ToList();
        ILookup<string?, WireType> typesByEnum = OwnMessages.SelectMany(message => message.Fields)
            .Where(field => field.Enum is not null && field.Type.IsInteger)
            .ToLookup(field => field.Enum, field => field.Type, StringComparer.Ordinal);
        OwnEnums = dialect.Enums.Where(definition => !Exists(
            _enums, definition.Name, existing?.Find(definition, typesByEnum[definition.Name]))).ToList();

        ExtendedEnums = OwnEnums.Where(definition =>
            Exists(_enums, definition.Name, existing?.FindExtended(definition, typesByEnum[definition.Name]))).ToList();
        NewEnums = OwnEnums.Except(ExtendedEnums).ToList();

        string prefix = PascalCase.Of(dialect.Name);
        DialectClass = prefix + "Dialect";
        _used.Add(DialectClass);
        foreach (ArrayType array in OwnArrays)
            _used.Add(_arrays[array] = array.Name);
        foreach (EnumDefinition definition in NewEnums)
            _enums[definition.Name] = Take(PascalCase.Of(definition.Name), "Enum", definition.Name);
        foreach (MessageDefinition message in OwnMessages)
            _messages[message.Id] = Take(
                PascalCase.Of(message.Name), "Message", message.Id.ToString(CultureInfo.InvariantCulture));
        foreach (EnumDefinition definition in ExtendedEnums)
            _addedEntries[definition.Name] = Take(prefix + PascalCase.Of(definition.Name), "Entries", definition.Name);
    }

    /// <summary>The messages that the package does not have in this form.</summary>
    public IReadOnlyList<MessageDefinition> OwnMessages { get; }

    /// <summary>The enums that the package does not have, or not with all these entries.</summary>
    public IReadOnlyList<EnumDefinition> OwnEnums { get; }

    /// <summary>Those of <see cref="OwnEnums"/> that are types of the dialect's own.</summary>
    public IReadOnlyList<EnumDefinition> NewEnums { get; }

    /// <summary>Those of <see cref="OwnEnums"/> that only add entries to an enum of the package.</summary>
    public IReadOnlyList<EnumDefinition> ExtendedEnums { get; }

    /// <summary>The arrays in the own messages that the package does not have.</summary>
    public IReadOnlyList<ArrayType> OwnArrays { get; }

    /// <summary>The class that gives the dialect as a value.</summary>
    public string DialectClass { get; }

    public bool IsOwn(MessageDefinition message) => _ownIds.Contains(message.Id);

    public string OfEnum(string name) => _enums[name];

    /// <summary>The class that holds what is added to an enum of the package.</summary>
    public string OfAddedEntries(string name) => _addedEntries[name];

    /// <summary>The entries that the package's enum does not have.</summary>
    public IReadOnlyList<EnumEntry> AddedEntries(EnumDefinition definition) =>
        definition.Entries.Where(entry => !_existing!.HasEntry(definition.Name, entry.Name)).ToList();

    public string OfMessage(MessageDefinition message) => _messages[message.Id];

    public string OfArray(ArrayType array) => _arrays[array];

    private static bool Exists<TKey>(Dictionary<TKey, string> names, TKey key, string? name)
        where TKey : notnull
    {
        if (name is not null)
            names[key] = name;
        return name is not null;
    }

    // Compared without case: file names are made of type names, and not every file system distinguishes case.
    private string Take(string name, string suffix, string last)
    {
        if (_used.Add(name))
            return name;
        if (_used.Add(name + suffix))
            return name + suffix;
        _used.Add(name + suffix + last);
        return name + suffix + last;
    }
}
