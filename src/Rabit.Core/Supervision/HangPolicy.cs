using System;
using System.Threading;

namespace Rabit.Core;

/// <summary>
/// How long a manager may be in its code before the watchdog finds that it hangs, and what follows. The finding is in
/// the log, the status and the result under every policy; a thread is never aborted. Immutable.
/// </summary>
public sealed class HangPolicy
{
    private static readonly TimeSpan Never = Timeout.InfiniteTimeSpan;

    private HangPolicy()
    {
    }

    /// <summary>
    /// The default: a start-up of more than 30 s, a unit of work or a shutdown of more than 5 s is reported.
    /// </summary>
    public static HangPolicy Report { get; } = new()
    {
        StartupLimit = TimeSpan.FromSeconds(30),
        UnitOfWorkLimit = TimeSpan.FromSeconds(5),
        ShutdownLimit = TimeSpan.FromSeconds(5),
    };

    /// <summary>
    /// As <see cref="Report"/>, and all managers are stopped in order; the one that hangs is given up when its time to
    /// stop is over.
    /// </summary>
    public static HangPolicy StopSystem { get; } = Report.AndStopSystem();

    /// <summary>No watchdog.</summary>
    public static HangPolicy Off { get; } =
        new() { StartupLimit = Never, UnitOfWorkLimit = Never, ShutdownLimit = Never };

    /// <summary>
    /// How long <see cref="RabitManager.Startup"/> may take; <see cref="Timeout.InfiniteTimeSpan"/> for as long as it
    /// likes.
    /// </summary>
    public TimeSpan StartupLimit { get; private init; }

    /// <summary>
    /// How long <see cref="RabitManager.ExecuteUnitOfWork"/> may take; <see cref="Timeout.InfiniteTimeSpan"/> for as
    /// long as it likes.
    /// </summary>
    public TimeSpan UnitOfWorkLimit { get; private init; }

    /// <summary>
    /// How long <see cref="RabitManager.Shutdown"/> may take; <see cref="Timeout.InfiniteTimeSpan"/> for as long as it
    /// likes.
    /// </summary>
    public TimeSpan ShutdownLimit { get; private init; }

    /// <summary>Whether a manager that hangs stops the system.</summary>
    public bool StopsSystem { get; private init; }

    /// <summary>
    /// Called once for each hang, on the watchdog's thread, so it must not wait for anything. What it throws is
    /// reported.
    /// </summary>
    public Action<ManagerHang>? Callback { get; private init; }

    /// <summary>The same with other limits.</summary>
    /// <param name="unitOfWork">For units of work.</param>
    /// <param name="startup">For start-up; null leaves it as it is.</param>
    /// <param name="shutdown">For shutdown; null leaves it as it is.</param>
    /// <exception cref="ArgumentOutOfRangeException">
    /// A limit is neither positive nor <see cref="Timeout.InfiniteTimeSpan"/>.
    /// </exception>
    public HangPolicy WithLimits(TimeSpan unitOfWork, TimeSpan? startup = null, TimeSpan? shutdown = null) => new()
    {
        UnitOfWorkLimit = Limit(unitOfWork, nameof(unitOfWork)),
        StartupLimit = Limit(startup ?? StartupLimit, nameof(startup)),
        ShutdownLimit = Limit(shutdown ?? ShutdownLimit, nameof(shutdown)),
        StopsSystem = StopsSystem,
        Callback = Callback,
    };

    /// <summary>The same, and a hang stops the system.</summary>
    public HangPolicy AndStopSystem() => With(stopsSystem: true, Callback);

    /// <summary>The same, and a hang calls the user back.</summary>
    /// <param name="callback">See <see cref="Callback"/>.</param>
    public HangPolicy AndCall(Action<ManagerHang> callback)
        => With(StopsSystem, Require.NotNull(callback, nameof(callback)));

    /// <summary>The limit of a stage; <see cref="TimeSpan.MaxValue"/> for none.</summary>
    internal TimeSpan LimitOf(ManagerStage stage)
    {
        TimeSpan limit = stage switch
        {
            ManagerStage.Startup => StartupLimit,
            ManagerStage.UnitOfWork => UnitOfWorkLimit,
            _ => ShutdownLimit,
        };
        return limit == Never ? TimeSpan.MaxValue : limit;
    }

    private static TimeSpan Limit(TimeSpan limit, string parameter)
        => limit > TimeSpan.Zero || limit == Never
            ? limit
            : throw new ArgumentOutOfRangeException(
                parameter, limit, "The limit of the watchdog must be above zero, or infinite.");

    private HangPolicy With(bool stopsSystem, Action<ManagerHang>? callback) => new()
    {
        StartupLimit = StartupLimit,
        UnitOfWorkLimit = UnitOfWorkLimit,
        ShutdownLimit = ShutdownLimit,
        StopsSystem = stopsSystem,
        Callback = callback,
    };
}
