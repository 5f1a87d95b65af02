using Microsoft.Extensions.Logging;
using Rabit.Core;

namespace Rabit.Hosting;

/// <summary>The event ids in the log of the host. They stay what they are.</summary>
public static class RabitEventIds
{
    /// <summary>A manager or the system started or stopped.</summary>
    public static readonly EventId Lifecycle = new(1, nameof(Lifecycle));

    /// <summary>A unit of work begins.</summary>
    public static readonly EventId Run = new(2, nameof(Run));

    /// <summary>An exception left user code.</summary>
    public static readonly EventId Fault = new(3, nameof(Fault));

    /// <summary>Something worth a look that is no fault.</summary>
    public static readonly EventId Note = new(4, nameof(Note));

    /// <summary>A manager's own words.</summary>
    public static readonly EventId Manager = new(5, nameof(Manager));

    /// <summary>A manager was found to hang, or has returned.</summary>
    public static readonly EventId Hang = new(6, nameof(Hang));

    /// <summary>A reactor ended by itself, and the host stops for it.</summary>
    public static readonly EventId ReactorEnded = new(10, nameof(ReactorEnded));

    /// <summary>A manager, reader or writer did not stop in time.</summary>
    public static readonly EventId NotStopped = new(11, nameof(NotStopped));

    /// <summary>systemd could not be notified.</summary>
    public static readonly EventId CannotNotify = new(12, nameof(CannotNotify));

    internal static EventId Of(RabitLogKind kind) => kind switch
    {
        RabitLogKind.Lifecycle => Lifecycle,
        RabitLogKind.Run => Run,
        RabitLogKind.Fault => Fault,
        RabitLogKind.Note => Note,
        RabitLogKind.Hang => Hang,
        _ => Manager,
    };
}
