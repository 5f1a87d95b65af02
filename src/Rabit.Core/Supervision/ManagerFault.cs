using System;
using System.Globalization;
using Rabit.Core.Diagnostics;

namespace Rabit.Core;

/// <summary>
/// An exception that left a manager's code, or that ended its thread in another unexpected way. Immutable.
/// </summary>
public sealed class ManagerFault
{
    private readonly string _text;

    internal ManagerFault(string manager, ManagerStage stage, TimeSpan time, Exception exception)
    {
        Manager = manager;
        Stage = stage;
        Time = time;
        Exception = exception;

        // Once, and now: the exception is foreign code, which has no place in a text that is read later.
        _text = string.Format(
            CultureInfo.InvariantCulture, "{0} in {1}: {2}", Manager, Stage, ExceptionText.Describe(exception));
    }

    /// <summary>The manager.</summary>
    public string Manager { get; }

    /// <summary>What it was doing.</summary>
    public ManagerStage Stage { get; }

    /// <summary>When, by <see cref="RabitManager.Now"/>.</summary>
    public TimeSpan Time { get; }

    /// <summary>What was thrown.</summary>
    public Exception Exception { get; }

    /// <summary>
    /// One line: manager, stage, type and message of the exception as it was then, cut where it is long.
    /// </summary>
    public override string ToString() => _text;
}
