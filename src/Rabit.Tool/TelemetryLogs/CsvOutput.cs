using System.Globalization;
using System.IO;
using System.Text;
using Rabit.Mavlink;

namespace Rabit.Tool.TelemetryLogs;

/// <summary>
/// Rows for a spreadsheet or a script (RFC 4180): time, system, component, sequence, then a column per field and per
/// element of an array. Numbers as they are on the wire, without units and names; texts in quotes where they need them.
/// </summary>
internal sealed class CsvOutput : IDumpOutput
{
    private readonly TextWriter _output;
    private readonly MavlinkMessageDefinition _definition;
    private readonly StringBuilder _row = new();

    public CsvOutput(TextWriter output, int messageId)
    {
        _output = output;
        _definition = MavlinkDialect.All.FindDefinition(messageId)
            ?? throw new ToolException(
                $"--csv: message {messageId.ToString(CultureInfo.InvariantCulture)} is in no definition, so its fields "
                    + "are not known.");
        WriteHeader();
    }

    public void Add(in MavlinkFrame frame, in TlogRecord record)
    {
        _row.Clear();
        RecordText.AppendTime(_row, record.TimeUtc);
        _row.Append(',').Append(frame.SystemId).Append(',').Append(frame.ComponentId).Append(',')
            .Append(frame.Sequence);
        for (int index = 0; index < _definition.Fields.Count; index++)
            AppendField(_definition.Fields[index], frame);
        _row.Append('\n');
        _output.Write(_row);
    }

    public void Finish(TlogReader log)
    {
        // Every row is out already.
    }

    private void WriteHeader()
    {
        _row.Append("time,system,component,sequence");
        foreach (MavlinkFieldDefinition field in _definition.Fields)
        {
            for (int index = 0; index < (field.IsText ? 1 : field.Count); index++)
            {
                _row.Append(',').Append(field.Name);
                if (field.ArrayLength != 0 && !field.IsText)
                    _row.Append('[').Append(index).Append(']');
            }
        }

        _output.Write(_row.Append('\n').ToString());
    }

    private void AppendField(MavlinkFieldDefinition field, in MavlinkFrame frame)
    {
        if (field.IsText)
        {
            _row.Append(',').Append(Quoted(field.GetText(frame)));
            return;
        }

        for (int index = 0; index < field.Count; index++)
        {
            _row.Append(',');
            field.GetValue(frame, index).AppendTo(_row);
        }
    }

    private static string Quoted(string text) =>
        text.IndexOfAny(['"', ',', '\r', '\n']) < 0 ? text : "\"" + text.Replace("\"", "\"\"") + "\"";
}
