using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Xml.Linq;
using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>Collects messages and checks each against the rules of a frame and against those read before.</summary>
internal sealed class MessageReader(EnumReader enums)
{
    /// <summary>Ids are three bytes on the wire (MAVLink guide, "Packet serialization").</summary>
    private const int LargestId = 0xFF_FFFF;

    /// <summary>The length of a payload is one byte on the wire.</summary>
    private const int LongestPayload = 255;

    private readonly List<MessageDefinition> _messages = [];

    public IReadOnlyList<MessageDefinition> Messages => _messages.OrderBy(message => message.Id).ToList();

    public void Read(DefinitionElement element)
    {
        if (element.Name("name", "A message") is not { } name || ReadId(element, name) is not { } id || ReadFields(element, name) is not { } fields)
            return;
        var message = new MessageDefinition(id, name, fields) { File = element.FileName, Description = element.Description, Marks = element.Marks };
        if (message.MaximumLength > LongestPayload)
            element.Fault(DialectFaultKind.PayloadTooLong, $"Message {name} has {message.MaximumLength} payload bytes; a frame holds {LongestPayload}.");
        else if (IsNew(message, element))
            _messages.Add(message);
    }

    private static int? ReadId(DefinitionElement element, string name)
    {
        string text = element.Attribute("id") ?? "";
        if (int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int id) && id <= LargestId)
            return id;
        element.Fault(DialectFaultKind.MalformedNumber, $"Message {name}: '{text}' is no id from 0 to {LargestId}.");
        return null;
    }

    private bool IsNew(MessageDefinition message, DefinitionElement element)
    {
        MessageDefinition? sameId = _messages.FirstOrDefault(other => other.Id == message.Id);
        MessageDefinition? sameName = _messages.FirstOrDefault(other => string.Equals(other.Name, message.Name, StringComparison.Ordinal));
        if (sameId is not null)
            element.Fault(DialectFaultKind.DuplicateMessageId, $"Message {message.Name} has id {message.Id}, which {sameId.Name} in {sameId.File} has already.");
        else if (sameName is not null)
            element.Fault(DialectFaultKind.DuplicateMessageName, $"Message {message.Name} is already defined in {sameName.File}, with id {sameName.Id}.");
        return sameId is null && sameName is null;
    }

    private List<FieldDefinition>? ReadFields(DefinitionElement element, string message)
    {
        var fields = new List<FieldDefinition>();
        bool isExtension = false;
        bool isSound = true;
        foreach (XElement child in element.Element.Elements())
        {
            if (child.Name.LocalName == "extensions")
                isExtension = true;
            if (child.Name.LocalName != "field")
                continue;
            DefinitionElement fieldElement = element.Child(child);
            FieldDefinition? field = FieldReader.Read(fieldElement, message, isExtension);
            isSound &= field is not null && IsAllowed(field, fields, fieldElement, message);
            if (field is not null)
                fields.Add(field);
        }

        return isSound ? fields : null;
    }

    private bool IsAllowed(FieldDefinition field, List<FieldDefinition> before, DefinitionElement element, string message)
    {
        bool isDuplicate = before.Any(other => string.Equals(other.Name, field.Name, StringComparison.Ordinal));
        bool isUnknownEnum = field.Enum is not null && !enums.Knows(field.Enum);
        if (isDuplicate)
            element.Fault(DialectFaultKind.DuplicateField, $"Message {message} has two fields called {field.Name}.");
        if (isUnknownEnum)
            element.Fault(DialectFaultKind.UnknownEnum, $"Field {field.Name} of message {message} is of enum {field.Enum}, which no file defines.");
        return !isDuplicate && !isUnknownEnum;
    }
}
