using System.IO;
using System.Text;
using Rabit.Mavlink;

namespace Rabit.Tool.TelemetryLogs;

/// <summary>One line for people per message: time, sender, name, fields with units and names of enum entries.</summary>
internal sealed class LineOutput(TextWriter output, LoggedEventTexts events) : IDumpOutput
{
    private readonly StringBuilder _line = new();

    public void Add(in MavlinkFrame frame, in TlogRecord record)
    {
        _line.Clear();
        RecordText.AppendTime(_line, record.TimeUtc);
        _line.Append("  ").Append(frame.SystemId).Append('/').Append(frame.ComponentId).Append("  ");
        if (MavlinkDialect.All.FindDefinition(frame.MessageId) is { } definition)
            definition.AppendTo(_line, frame);
        else
            _line.Append(RecordText.NameOf(frame, record)).Append(' ').Append(RecordText.PayloadHex(frame));
        if (events.Of(frame) is { } text)
            _line.Append("  \"").Append(text).Append('"');
        _line.Append('\n');
        output.Write(_line);
    }

    public void Finish(TlogReader log)
    {
        // Every line is out already.
    }
}
