using System;
using System.Globalization;

namespace Rabit.Core;

/// <summary>An exception that left a manager's code. Immutable.</summary>
public sealed class ManagerFault
{
    internal ManagerFault(string manager, ManagerStage stage, TimeSpan time, Exception exception)
    {
        Manager = manager;
        Stage = stage;
        Time = time;
        Exception = exception;
    }

    /// <summary>The manager.</summary>
    public string Manager { get; }

    /// <summary>What it was doing.</summary>
    public ManagerStage Stage { get; }

    /// <summary>When, by <see cref="RabitManager.Now"/>.</summary>
    public TimeSpan Time { get; }

    /// <summary>What was thrown.</summary>
    public Exception Exception { get; }

    /// <inheritdoc/>
    public override string ToString() => string.Format(
        CultureInfo.InvariantCulture, "{0} in {1}: {2}: {3}", Manager, Stage, Exception.GetType().Name,
        Exception.Message);
}
