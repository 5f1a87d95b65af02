using System;
using System.IO;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Tool.TelemetryLogs;

/// <summary>The texts of the events in a log of PX4, from the metadata of its build.</summary>
internal sealed class LoggedEventTexts
{
    private readonly MavlinkEventCatalog? _catalog;

    /// <param name="file">The file all_events.json; null for none.</param>
    public LoggedEventTexts(string? file) => _catalog = file is null ? null : Read(file);

    /// <summary>The text of a frame that carries an event; null of others, and of events that are not known.</summary>
    public string? Of(in MavlinkFrame frame)
    {
        if (_catalog is null || frame.MessageId != Event.MavlinkId || !frame.TryDecode(out Event message))
            return null;
        var source = new MavlinkAddress(frame.SystemId, frame.ComponentId);
        return _catalog.Find(message.Id)?.MessageOf(new MavlinkEvent(source, message));
    }

    private static MavlinkEventCatalog Read(string file)
    {
        try
        {
            using FileStream stream = File.OpenRead(file);
            return MavlinkEventCatalog.Read(stream);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException
            or FormatException)
        {
            throw new ToolException($"--px4-events {file}: {e.Message.TrimEnd('.')}.", e);
        }
    }
}
