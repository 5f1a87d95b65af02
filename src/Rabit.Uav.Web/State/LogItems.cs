using System.Globalization;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Web.State;

/// <summary>The last lines of the log, and the texts of the autopilot among them: a ring of values.</summary>
internal sealed class LogItems(string prefix, LiveLog? log)
{
    private const int Kept = 200;

    // The lines that the page takes at once: the rest waits for the next turn.
    private const int AtOnce = 50;

    private RecentItems<StatusText> _texts = RecentItems<StatusText>.None;
    private long _count;

    public void Write(ItemWriter writer, RecentItems<StatusText> texts)
    {
        // What was there the last time is still there, behind what is new.
        StatusText? known = _texts.Newest;
        foreach (StatusText text in texts.TakeWhile(t => !ReferenceEquals(t, known)).Reverse())
            Write(writer, new LiveLogLine(
                text.Time, "autopilot", text.Text, text.Severity <= MavSeverity.Warning));
        _texts = texts;
        for (int taken = 0; taken < AtOnce && log is not null && log.TryTake(out LiveLogLine line); taken++)
            Write(writer, line);
    }

    private void Write(ItemWriter writer, LiveLogLine line)
    {
        writer.Object(string.Create(CultureInfo.InvariantCulture, $"{prefix}/log/{_count % Kept}"))
            .Count("n", ++_count).Number("t", line.Time.TotalSeconds, 1).Text("from", line.Source, 40)
            .Text("text", line.Text).Flag("fault", line.IsFault).End();
    }
}
