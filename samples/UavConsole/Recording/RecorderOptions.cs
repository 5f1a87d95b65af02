using System;
using System.Collections.Generic;
using Rabit.Uav.ImageProcessing;

namespace UavConsole;

/// <summary>When the recorder, which sees how the mission goes, ends the run, and where it finds pictures.</summary>
internal sealed class RecorderOptions
{
    /// <summary>Whether the end of the mission is the end of the run.</summary>
    public bool StopsWhenMissionEnds { get; init; }

    /// <summary>A mission that is not over by then is given up; null for any length.</summary>
    public TimeSpan? MaxMission { get; init; }

    /// <summary>The newest pieces of pictures. Called by the recorder's thread.</summary>
    public Func<IReadOnlyList<ImageChip>> ImageChips { get; init; } = () => [];
}
