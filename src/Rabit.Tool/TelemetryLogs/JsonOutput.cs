using System.IO;
using System.Text;
using System.Text.Json;
using Rabit.Mavlink;

namespace Rabit.Tool.TelemetryLogs;

/// <summary>
/// One object per line: time, sender, name, fields as they are on the wire. NaN and the infinities, which JSON does not
/// have, are null. Of an unknown message the payload is given in hexadecimal digits.
/// </summary>
#pragma warning disable CA1001   // The writer is flushed at each record and owns nothing that must be given back.
internal sealed class JsonOutput(Stream output, LoggedEventTexts events) : IDumpOutput
{
    private readonly Utf8JsonWriter _json = new(output);
    private readonly StringBuilder _time = new();

    public void Add(in MavlinkFrame frame, in TlogRecord record)
    {
        _json.Reset();
        _time.Clear();
        RecordText.AppendTime(_time, record.TimeUtc);
        _json.WriteStartObject();
        _json.WriteString("time", _time.ToString());
        _json.WriteNumber("system", frame.SystemId);
        _json.WriteNumber("component", frame.ComponentId);
        _json.WriteNumber("sequence", frame.Sequence);
        _json.WriteString("message", RecordText.NameOf(frame, record));
        if (MavlinkDialect.All.FindDefinition(frame.MessageId) is { } definition)
            WriteFields(definition, frame);
        else
            _json.WriteString("payload", RecordText.PayloadHex(frame));
        if (events.Of(frame) is { } text)
            _json.WriteString("text", text);
        _json.WriteEndObject();
        _json.Flush();
        output.WriteByte((byte)'\n');
    }

    public void Finish(TlogReader log)
    {
        // Every line is out already.
    }

    private void WriteFields(MavlinkMessageDefinition definition, in MavlinkFrame frame)
    {
        _json.WriteStartObject("fields");
        for (int place = 0; place < definition.Fields.Count; place++)
        {
            MavlinkFieldDefinition field = definition.Fields[place];
            _json.WritePropertyName(field.Name);
            if (field.IsText)
                _json.WriteStringValue(field.GetText(frame));
            else if (field.ArrayLength == 0)
                WriteNumber(field.GetValue(frame));
            else
                WriteArray(field, frame);
        }

        _json.WriteEndObject();
    }

    private void WriteArray(MavlinkFieldDefinition field, in MavlinkFrame frame)
    {
        _json.WriteStartArray();
        for (int index = 0; index < field.ArrayLength; index++)
            WriteNumber(field.GetValue(frame, index));
        _json.WriteEndArray();
    }

    private void WriteNumber(MavlinkFieldValue value)
    {
        if (!value.IsFloatingPoint && value.Type == MavlinkFieldType.UInt64)
            _json.WriteNumberValue(value.ToUInt64());
        else if (!value.IsFloatingPoint)
            _json.WriteNumberValue(value.ToInt64());
        else if (double.IsNaN(value.ToDouble()) || double.IsInfinity(value.ToDouble()))
            _json.WriteNullValue();
        else
            _json.WriteRawValue(value.ToString(), skipInputValidation: true);   // the fewest digits on every runtime
    }
}
