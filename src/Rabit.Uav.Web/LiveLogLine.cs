using System;

namespace Rabit.Uav.Web;

/// <summary>A line of the log on the page.</summary>
/// <param name="Time">By the clock of the run.</param>
/// <param name="Source">Who says it.</param>
/// <param name="Text">What it says.</param>
/// <param name="IsFault">Whether something is broken.</param>
internal readonly record struct LiveLogLine(TimeSpan Time, string Source, string Text, bool IsFault);
