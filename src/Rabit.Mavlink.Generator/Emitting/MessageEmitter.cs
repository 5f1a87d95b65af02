using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Generator.Naming;

namespace Rabit.Mavlink.Generator.Emitting;

/// <summary>
/// Writes one message as a plain struct: one variable and one property per field, encode and decode in wire order.
/// </summary>
internal sealed class MessageEmitter
{
    private readonly GeneratedTypeNames _names;
    private readonly MessageDefinition _message;
    private readonly SourceWriter _writer;
    private readonly string _typeName;
    private readonly IReadOnlyDictionary<FieldDefinition, string> _properties;

    public MessageEmitter(GeneratedTypeNames names, MessageDefinition message, SourceWriter writer)
    {
        _names = names;
        _message = message;
        _writer = writer;
        _typeName = names.OfMessage(message);
        _properties = PropertyNames.Of(message, _typeName);
    }

    public void Emit()
    {
        string fact = $"{DocComment.Code(_message.Name)}, message {_message.Id} of {DocComment.Escape(_message.File)}.";
        DocComment.Summary(
            _writer,
            _message.Description is null ? fact : DocComment.Join([DocComment.Sentence(_message.Description), fact]));
        DocComment.Remarks(_writer, DocComment.Marks(_message.Marks, _message.ReplacedBy).ToList());
        _writer.Open($"public struct {_typeName} : IMavlinkMessage");
        EmitConstants();
        _writer.Blank();
        // Variables in wire order: large ones first leaves no gaps between them.
        foreach (FieldDefinition field in _message.WireFields)
            _writer.Line($"private {TypeOf(field)} {Variable(field)};");
        foreach (FieldDefinition field in _message.Fields)
            EmitProperty(field);
        EmitInterface();
        EmitEncode();
        EmitDecode();
        _writer.Close();
    }

    private void EmitConstants()
    {
        Constant("int", "MavlinkId", Number(_message.Id), $"Message id: {_message.Id}.");
        Constant("string", "MavlinkName", $"\"{_message.Name}\"", "Name in the definition.");
        Constant("byte", "MavlinkCrcExtra", Number(_message.CrcExtra), "The byte that ends the checksum.");
        Constant("byte", "MavlinkMinLength", Number(_message.MinLength), "Payload bytes without extension fields.");
        Constant("byte", "MavlinkMaxLength", Number(_message.MaxLength), "Payload bytes with extension fields.");
    }

    private void Constant(string type, string name, string value, string doc)
    {
        DocComment.Summary(_writer, doc);
        _writer.Line($"public const {type} {name} = {value};");
    }

    private void EmitProperty(FieldDefinition field)
    {
        _writer.Blank();
        FieldDocs.Write(_writer, field, _names, isRenamed: PropertyNames.IsCalledLikeMessage(field, _typeName));
        _writer.Open($"public {TypeOf(field)} {_properties[field]}");
        _writer.Line($"get {{ return {Variable(field)}; }}");
        _writer.Line($"set {{ {Variable(field)} = value; }}");
        _writer.Close();
    }

    // Explicit, so that a field may be called message_id.
    private void EmitInterface()
    {
        _writer.Blank();
        _writer.Line("int IMavlinkMessage.MessageId { get { return MavlinkId; } }");
        _writer.Line("byte IMavlinkMessage.CrcExtra { get { return MavlinkCrcExtra; } }");
        _writer.Line("int IMavlinkMessage.MinLength { get { return MavlinkMinLength; } }");
        _writer.Line("int IMavlinkMessage.MaxLength { get { return MavlinkMaxLength; } }");
    }

    private void EmitEncode()
    {
        _writer.Blank();
        _writer.Line("/// <inheritdoc/>");
        _writer.Open("public void Encode(global::System.Span<byte> payload)");
        EmitLengthCheck();
        foreach (FieldDefinition field in _message.WireFields)
            _writer.Line(Write(field, _message.OffsetOf(field)));
        _writer.Close();
    }

    private void EmitDecode()
    {
        _writer.Blank();
        _writer.Line("/// <inheritdoc/>");
        _writer.Open("public void Decode(global::System.ReadOnlySpan<byte> payload)");
        EmitLengthCheck();
        foreach (FieldDefinition field in _message.WireFields)
            _writer.Line(Read(field, _message.OffsetOf(field)));
        _writer.Close();
    }

    private void EmitLengthCheck()
    {
        _writer.Line("if (payload.Length < MavlinkMaxLength)");
        _writer.Line(
            "    MavlinkPayload.ThrowTooShort(nameof(payload), MavlinkName, MavlinkMaxLength, payload.Length);");
    }

    private string Write(FieldDefinition field, int offset)
    {
        string variable = Variable(field);
        if (field.ArrayLength != 0)
            return $"{variable}.WriteTo(payload, {offset});";
        if (!field.Type.IsInteger)
            return $"MavlinkPayload.Write{field.Type.ClrName}(payload, {offset}, ref {variable});";
        string value = HasEnumType(field) ? $"unchecked(({field.Type.CSharpName}){variable})" : variable;
        return $"MavlinkPayload.Write{field.Type.ClrName}(payload, {offset}, {value});";
    }

    private string Read(FieldDefinition field, int offset)
    {
        string variable = Variable(field);
        if (field.ArrayLength != 0)
            return $"{variable}.ReadFrom(payload, {offset});";
        if (!field.Type.IsInteger)
            return $"MavlinkPayload.Read{field.Type.ClrName}(payload, {offset}, out {variable});";
        string value = $"MavlinkPayload.Read{field.Type.ClrName}(payload, {offset})";
        return HasEnumType(field)
            ? $"{variable} = unchecked(({_names.OfEnum(field.Enum!)}){value});"
            : $"{variable} = {value};";
    }

    // Arrays of enum values stay arrays of numbers; their doc names the enum.
    private static bool HasEnumType(FieldDefinition field)
        => field.Enum is not null && field.ArrayLength == 0 && field.Type.IsInteger;

    private string TypeOf(FieldDefinition field) =>
        field.ArrayLength != 0 ? _names.OfArray(ArrayType.Of(field))
            : HasEnumType(field) ? _names.OfEnum(field.Enum!)
            : field.Type.CSharpName;

    private string Variable(FieldDefinition field)
    {
        string property = _properties[field];
        return "_" + char.ToLowerInvariant(property[0]) + property.Substring(1);
    }

    private static string Number(int value) => value.ToString(CultureInfo.InvariantCulture);
}
