using System;
using System.Globalization;
using System.Linq;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Reactors;

/// <content>
/// What keeps a run from ending its thread, or from standing still: the last catch around each step, and the count of
/// the runs at one instant.
/// </content>
internal sealed partial class VirtualEngine
{
    // As Guard, without an allocation.
    private NextStep RunStep(VirtualSlot slot, ConsumedWakeUps wakes, TimeSpan? wokenAt)
    {
        try
        {
            return slot.Activity.RunStep(wakes, wokenAt);
        }
        catch (Exception e)
        {
            EndAfter(slot, e);
            return NextStep.Never;
        }
    }

    private void Guard(VirtualSlot slot, Action action)
    {
        try
        {
            action();
        }
        catch (Exception e)
        {
            EndAfter(slot, e);
        }
    }

    private void EndAfter(VirtualSlot slot, Exception unexpected)
    {
        LastResort.End(slot.Activity, unexpected, _context.Fail);
        slot.HasEnded = true;
    }

    // A run that waits for a stop, at full speed, may wait in vain.
    private TimeSpan LimitOf(TimeSpan end)
        => end == TimeSpan.MaxValue && _pacer.IsUnlimited
            ? Times.Later(_context.Clock.Now, _time.MaxDuration)
            : TimeSpan.MaxValue;

    private void FailWithoutStop()
        => _context.Fail(new InvalidOperationException(string.Format(
            CultureInfo.InvariantCulture,
            "The run was not stopped within {0} of virtual time ({1}.{2}). Is a call of Stop or StopSystem missing?",
            _time.MaxDuration,
            nameof(VirtualTime),
            nameof(VirtualTime.MaxDuration))));

    private bool TryCountRun()
    {
        if (++_runsAtInstant <= _time.MaxRunsPerInstant)
            return true;

        FailStandingStill();
        return false;
    }

    // Apart from the count, which is hot: what this captures is made only when it is called.
    private void FailStandingStill()
    {
        // Who ran once is a bystander, unless all did.
        int fewest = _slots.Exists(s => s.RunsAtInstant > 1) ? 2 : 1;
        string names = string.Join(", ", _slots
            .Where(s => s.RunsAtInstant >= fewest)
            .OrderByDescending(s => s.RunsAtInstant)
            .Select(s => string.Format(CultureInfo.InvariantCulture, "{0} ({1})", s.Activity.Name, s.RunsAtInstant)));
        _context.Fail(new InvalidOperationException(string.Format(
            CultureInfo.InvariantCulture,
            "Virtual time stands still at {0}: more than {1} runs at one instant, by {2}. Do they wake each other "
                + "forever?",
            _context.Clock.Now,
            _time.MaxRunsPerInstant,
            names)));
    }
}
