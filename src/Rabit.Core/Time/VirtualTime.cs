using System;
using System.Collections.Generic;
using System.IO;
using Rabit.Core.Diagnostics;
using Rabit.Core.Reactors;
using Rabit.Core.Time;
using Rabit.Core.Wiring;

namespace Rabit.Core;

/// <summary>
/// Virtual time: the same managers, unchanged, run in steps on one thread under a clock that jumps to the next event.
/// Who goes first among equals is fixed by the seed: one seed, one run, to the byte; another seed, another legal order.
/// </summary>
/// <remarks>
/// Configure before the start; after that read only, but for modelled durations. A wake, post, push or stop from a
/// thread that is not the run's own is taken between steps and lies outside that promise. One instance serves one
/// reactor.
/// </remarks>
/// <example>
/// <code>
/// var reactor = new RabitReactor(new VirtualTime(seed: 1)) { new Counter(), new Display() };
/// reactor.Start();
/// reactor.RunFor(TimeSpan.FromHours(1));   // in a second or less
/// reactor.Stop();
/// ReactorResult result = reactor.Finish();
/// </code>
/// </example>
public sealed class VirtualTime : RabitTime
{
    private readonly VirtualClock _clock;
    private readonly Dictionary<string, UnitOfWorkDurations> _durations = new(StringComparer.Ordinal);
    private double _pace = double.PositiveInfinity;
    private int _maxRunsPerInstant = 10_000;
    private TimeSpan _maxDuration = TimeSpan.FromDays(1);
    private bool _isUsed;
    private bool _hasManagers;

    /// <summary>Virtual time that starts on 1 January 2000, UTC.</summary>
    /// <param name="seed">Fixes the order among managers that could run at the same instant.</param>
    public VirtualTime(long seed = 0)
        : this(seed, new DateTimeOffset(2000, 1, 1, 0, 0, 0, TimeSpan.Zero))
    {
    }

    /// <summary>
    /// Virtual time that starts at a chosen wall time, for example that of the first record of a log.
    /// </summary>
    /// <param name="seed">Fixes the order among managers that could run at the same instant.</param>
    /// <param name="startUtc">What the wall clock says at the start.</param>
    public VirtualTime(long seed, DateTimeOffset startUtc)
    {
        Seed = seed;
        _clock = new VirtualClock(startUtc);
    }

    /// <summary>Fixes the order among equals.</summary>
    public long Seed { get; }

    /// <summary>
    /// How many virtual seconds pass in a real one at most; by default as many as the machine can (infinity).
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">Not above zero.</exception>
    public double Pace
    {
        get => _pace;
        set
            => _pace = value > 0
                ? value
                : throw new ArgumentOutOfRangeException(
                    nameof(value), value, "The pace of virtual time must be above zero.");
    }

    /// <summary>
    /// How many steps may run at one instant before the run stops with an error that names the managers: two that
    /// wake each other forever would freeze the clock. 10 000 by default.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">Not above zero.</exception>
    public int MaxRunsPerInstant
    {
        get => _maxRunsPerInstant;
        set => _maxRunsPerInstant = value > 0
            ? value
            : throw new ArgumentOutOfRangeException(
                nameof(value), value, "At least one run must be allowed at an instant.");
    }

    /// <summary>
    /// How long, in virtual time, <see cref="RabitReactor.Run"/> and <see cref="RabitReactor.Finish"/> let the managers
    /// work before the run stops with an error: one that is never stopped would continue forever. A day by default;
    /// <see cref="TimeSpan.MaxValue"/> for no limit. <see cref="RabitReactor.RunFor"/> has its own, and a run that is
    /// held back by <see cref="Pace"/> has none.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">Not above zero.</exception>
    public TimeSpan MaxDuration
    {
        get => _maxDuration;
        set => _maxDuration = Require.Positive(value, nameof(value), "The longest run in virtual time");
    }

    /// <summary>
    /// Where the run writes its event log: one line for each step (who, why, after how many merged wakes, its modelled
    /// duration), wake from sleep, post (with its version), change of a queue during a step, manager's own line, fault,
    /// start and stop. The same seed gives the same text to the byte, on .NET and on Mono. Null, the default, for none,
    /// which costs nothing.
    /// </summary>
    /// <remarks>
    /// Set before the reactor is made. Lines end in a line feed; times are seconds, exact to the tick. Flushed when the
    /// run ends, not disposed. A writer that throws fails the run. What comes from code outside managers is logged as
    /// by "outside"; the texts of exceptions that the runtime itself throws may differ between runtimes.
    /// </remarks>
    public TextWriter? EventLog { get; set; }

    /// <inheritdoc/>
    public override TimeProvider Clock => _clock;

    internal override bool AllowsBlocking => false;

    internal VirtualClock VirtualClock => _clock;

    /// <summary>
    /// Steps what the wall clock says, as where NTP or a user sets it. The time of the run goes on as before. Any
    /// thread; at a time of the run that is chosen between two calls of <see cref="RabitReactor.RunFor"/>.
    /// </summary>
    /// <param name="by">How far; negative is back.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such date.</exception>
    public void StepWallClock(TimeSpan by) => _clock.StepUtc(by);

    /// <summary>
    /// Models how long each unit of work of a manager takes. Without it a unit of work takes no time. What it posts and
    /// pushes is there at its beginning; the manager is busy, and keeps its wakes, until its end.
    /// </summary>
    /// <param name="managerName">The manager; a name that no manager has is an error at the start.</param>
    /// <param name="duration">Zero or longer.</param>
    /// <remarks>
    /// Before the start, or between two calls of <see cref="RabitReactor.RunFor"/>: it then holds from the next unit of
    /// work. The watchdog watches only managers whose units of work were modelled before the start to take longer than
    /// their limit.
    /// </remarks>
    /// <exception cref="ArgumentOutOfRangeException">The duration is negative.</exception>
    /// <exception cref="ArgumentException">The managers have started, and none has that name.</exception>
    public void SetUnitOfWorkDuration(string managerName, TimeSpan duration)
        => SetUnitOfWorkDuration(managerName, duration, duration);

    /// <summary>
    /// As <see cref="SetUnitOfWorkDuration(string, TimeSpan)"/>, with a random duration for each unit of work, uniform
    /// between the two alike. The draws come from the seed, apart from those of the order and of other managers.
    /// </summary>
    /// <param name="managerName">The manager; a name that no manager has is an error at the start.</param>
    /// <param name="shortest">Zero or longer.</param>
    /// <param name="longest">Not below the shortest.</param>
    /// <exception cref="ArgumentOutOfRangeException">
    /// A duration is negative, or the longest below the shortest.
    /// </exception>
    /// <exception cref="ArgumentException">The managers have started, and none has that name.</exception>
    public void SetUnitOfWorkDuration(string managerName, TimeSpan shortest, TimeSpan longest)
    {
        if (shortest < TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(
                nameof(shortest), shortest, $"Manager '{managerName}': a unit of work cannot take less than no time.");
        if (longest < shortest)
            throw new ArgumentOutOfRangeException(
                nameof(longest), longest,
                $"Manager '{managerName}': the longest unit of work cannot be shorter than the shortest, {shortest}.");
        DurationsFor(managerName).SetUsual(shortest, longest);
    }

    /// <summary>
    /// Models one unit of work that takes longer than the others: the first one that begins at a time or later. The
    /// watchdog finds it (<see cref="HangPolicy"/>) when it takes longer than its limit.
    /// </summary>
    /// <param name="managerName">The manager; a name that no manager has is an error at the start.</param>
    /// <param name="at">When, by the clock of the run.</param>
    /// <param name="duration">How long it takes; <see cref="TimeSpan.MaxValue"/> for one that never returns.</param>
    /// <exception cref="ArgumentOutOfRangeException">A time is negative.</exception>
    /// <exception cref="ArgumentException">The managers have started, and none has that name.</exception>
    public void AddLongUnitOfWork(string managerName, TimeSpan at, TimeSpan duration)
    {
        if (at < TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(nameof(at), at, $"Manager '{managerName}': a run begins at no time.");
        if (duration < TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(
                nameof(duration), duration, $"Manager '{managerName}': a unit of work cannot take less than no time.");
        DurationsFor(managerName).Add(at, duration);
    }

    /// <summary>Whose units of work take time; once managers have begun, these too.</summary>
    internal IEnumerable<string> ModelledManagers => _durations.Keys;

    internal TimeSpan MaxUnitOfWorkDuration(string managerName)
        => _durations.TryGetValue(managerName, out UnitOfWorkDurations? found) ? found.Longest : TimeSpan.Zero;

    /// <summary>All managers have begun: from now on a name that none of them has is an error at once.</summary>
    internal void CloseManagers() => _hasManagers = true;

    internal override EventLog? CreateEventLog(RunClock clock, Action<Exception> fail)
        => EventLog is null ? null : new EventLog(EventLog, clock, fail);

    internal override ReactorEngine CreateEngine(EngineContext context)
    {
        if (_isUsed)
            throw new InvalidOperationException("This virtual time has a reactor already; its clock cannot serve two.");
        _isUsed = true;
        return new VirtualEngine(this, context);
    }

    /// <summary>The model of one manager's units of work; asked for each manager when it begins.</summary>
    internal UnitOfWorkDurations DurationsFor(string managerName)
    {
        string name = Require.Name(managerName, nameof(managerName), "A manager");
        if (_durations.TryGetValue(name, out UnitOfWorkDurations? durations))
            return durations;
        if (_hasManagers)
            throw NameSuggestion.NotStarted(name, ModelledManagers, nameof(managerName));
        _durations.Add(name, durations = new UnitOfWorkDurations(Seed, name));
        return durations;
    }
}
