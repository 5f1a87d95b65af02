using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.Simulation;

/// <summary>Which of the scripted faults of pictures hold for the picture that is taken now. One thread.</summary>
internal sealed class PictureFaults(IReadOnlyList<ScriptedFault> faults)
{
    private readonly ScriptedFault[] _all = faults.Where(f => IsOfPictures(f.Kind)).ToArray();
    private readonly List<ScriptedFault> _active = [];

    /// <summary>Those that hold now.</summary>
    public IReadOnlyList<ScriptedFault> Active => _active;

    /// <summary>Whether the picture is the last one before.</summary>
    public bool IsFrozen { get; private set; }

    /// <summary>Whether it has noise of its own.</summary>
    public bool HasNewNoise { get; private set; } = true;

    /// <summary>The number that it has instead of its own.</summary>
    public long? RepeatedNumber { get; private set; }

    /// <summary>How much later its time is than the truth.</summary>
    public TimeSpan TimeOff { get; private set; }

    public static bool IsOfPictures(ScriptedFaultKind kind)
        => kind is ScriptedFaultKind.PicturesBlack or ScriptedFaultKind.PicturesWhite
            or ScriptedFaultKind.PicturesFrozen or ScriptedFaultKind.PicturesDefocused
            or ScriptedFaultKind.PicturesCovered or ScriptedFaultKind.PicturesMotionBlurred
            or ScriptedFaultKind.PictureNumbersRepeat
            or ScriptedFaultKind.PictureTimesOff;

    /// <summary>What holds for a picture.</summary>
    /// <param name="start">When its exposure begins.</param>
    /// <param name="number">Its own number.</param>
    public void Update(TimeSpan start, long number)
    {
        if (_all.Length == 0)
            return;
        _active.Clear();
        (IsFrozen, HasNewNoise, TimeOff) = (false, true, TimeSpan.Zero);
        long? repeated = RepeatedNumber;
        RepeatedNumber = null;
        foreach (ScriptedFault fault in _all)
        {
            if (!fault.IsOn(start))
                continue;
            _active.Add(fault);
            switch (fault.Kind)
            {
                case ScriptedFaultKind.PicturesFrozen:
                    (IsFrozen, HasNewNoise) = (number > 0, fault.Value.Equals(1d));
                    break;
                case ScriptedFaultKind.PictureNumbersRepeat:
                    RepeatedNumber = repeated ?? number;
                    break;
                case ScriptedFaultKind.PictureTimesOff:
                    TimeOff = TimeSpan.OfSeconds(fault.Value);
                    break;
            }
        }
    }
}
