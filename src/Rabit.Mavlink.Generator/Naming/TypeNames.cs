using System;
using System.Collections.Generic;
using System.Globalization;
using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Naming;

/// <summary>
/// Names of the types of a dialect. Enums and messages are their names in the definition, in Pascal case. An enum whose name is
/// taken gets Enum behind it, a message whose name is taken Message, and if that is taken too its id.
/// </summary>
internal sealed class TypeNames
{
    private readonly Dictionary<string, string> _enums = new(StringComparer.Ordinal);
    private readonly Dictionary<int, string> _messages = [];

    // What generated code itself refers to by its bare name.
    private readonly HashSet<string> _used = new(StringComparer.OrdinalIgnoreCase)
    {
        "MavlinkPayload", "MavlinkArray", "MavlinkText", "MavlinkDialect", "MavlinkMessageInfo", "IMavlinkMessage",
    };

    public TypeNames(Dialect dialect, IEnumerable<string> arrayNames)
    {
        foreach (string name in arrayNames)
            _used.Add(name);
        foreach (EnumDefinition definition in dialect.Enums)
            _enums[definition.Name] = Take(PascalCase.Of(definition.Name), "Enum", definition.Name);
        foreach (MessageDefinition message in dialect.Messages)
            _messages[message.Id] = Take(PascalCase.Of(message.Name), "Message", message.Id.ToString(CultureInfo.InvariantCulture));
    }

    public string OfEnum(string name) => _enums[name];

    public string OfMessage(MessageDefinition message) => _messages[message.Id];

    // Compared without case: file names are made of type names, and not every file system tells case apart.
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
