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
    private const int MaxId = 0xFF_FFFF;

    /// <summary>The length of a payload is one byte on the wire.</summary>
    private const int MaxPayload = 255;

    /// <summary>
    /// What MAVLink's own C library can describe, and mavgen accepts (MAVLink guide, "MAVLink XML schema").
    /// </summary>
    private const int MaxFields = 64;

    private readonly List<MessageDefinition> _messages = [];
    private readonly List<EnumUse> _enumUses = [];

    public IReadOnlyList<MessageDefinition> Messages => _messages.OrderBy(message => message.Id).ToList();

    /// <summary>The fields that are of an enum, in the order of reading.</summary>
    public IReadOnlyList<EnumUse> EnumUses => _enumUses;

    public void Read(DefinitionElement element)
    {
        if (element.Name("name", "A message") is not { } name || ReadId(element, name) is not { } id
            || ReadFields(element, name) is not { } read)
            return;
        List<FieldDefinition> fields = read.Select(pair => pair.Field).ToList();
        var message = new MessageDefinition(id, name, fields)
        {
            File = element.FileName,
            Description = element.Description,
            Marks = element.Marks,
            ReplacedBy = element.ReplacedBy,
        };
        if (fields.Count == 0)
            element.Fault(DialectFaultKind.NoFields, $"Message {name} has no field.");
        else if (fields.Count > MaxFields)
            element.Fault(
                DialectFaultKind.TooManyFields,
                $"Message {name} has {fields.Count} fields; MAVLink allows {MaxFields}.");
        else if (message.MaxLength > MaxPayload)
            element.Fault(
                DialectFaultKind.PayloadTooLong,
                $"Message {name} has {message.MaxLength} payload bytes; a frame holds {MaxPayload}.");
        else if (IsNew(message, element))
            Add(message, read);
    }

    private void Add(MessageDefinition message, List<(FieldDefinition Field, DefinitionElement Element)> fields)
    {
        _messages.Add(message);
        _enumUses.AddRange(
            fields.Where(pair => pair.Field.Enum is not null)
                .Select(pair => new EnumUse(message, pair.Field, pair.Element)));
    }

    private static int? ReadId(DefinitionElement element, string name)
    {
        string text = element.Attribute("id") ?? "";
        if (int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int id) && id <= MaxId)
            return id;
        element.Fault(DialectFaultKind.MalformedNumber, $"Message {name}: '{text}' is no id from 0 to {MaxId}.");
        return null;
    }

    private bool IsNew(MessageDefinition message, DefinitionElement element)
    {
        MessageDefinition? sameId = _messages.FirstOrDefault(other => other.Id == message.Id);
        MessageDefinition? sameName = _messages.FirstOrDefault(
            other => string.Equals(other.Name, message.Name, StringComparison.Ordinal));
        if (sameId is not null)
            element.Fault(
                DialectFaultKind.DuplicateMessageId,
                $"Message {message.Name} has id {message.Id}, which {sameId.Name} in {sameId.File} has already.");
        else if (sameName is not null)
            element.Fault(
                DialectFaultKind.DuplicateMessageName,
                $"Message {message.Name} is already defined in {sameName.File}, with id {sameName.Id}.");
        return sameId is null && sameName is null;
    }

    private List<(FieldDefinition Field, DefinitionElement Element)>? ReadFields(
        DefinitionElement element, string message)
    {
        var fields = new List<(FieldDefinition Field, DefinitionElement Element)>();
        bool isExtension = false;
        bool isValid = true;
        foreach (XElement child in element.Element.Elements())
        {
            if (child.Name.LocalName == "extensions")
                isExtension = true;
            if (child.Name.LocalName != "field")
                continue;
            DefinitionElement fieldElement = element.Child(child);
            FieldDefinition? field = FieldReader.Read(fieldElement, message, isExtension);
            isValid &= field is not null && IsAllowed(field, fields.Select(pair => pair.Field), fieldElement, message);
            if (field is not null)
                fields.Add((field, fieldElement));
        }

        return isValid ? fields : null;
    }

    private bool IsAllowed(
        FieldDefinition field, IEnumerable<FieldDefinition> before, DefinitionElement element, string message)
    {
        bool isDuplicate = before.Any(other => string.Equals(other.Name, field.Name, StringComparison.Ordinal));
        bool isUnknownEnum = field.Enum is not null && !enums.Knows(field.Enum);
        if (isDuplicate)
            element.Fault(DialectFaultKind.DuplicateField, $"Message {message} has two fields called {field.Name}.");
        if (isUnknownEnum)
            element.Fault(
                DialectFaultKind.UnknownEnum,
                $"Field {field.Name} of message {message} is of enum {field.Enum}, which no file defines.");
        return !isDuplicate && !isUnknownEnum;
    }
}
