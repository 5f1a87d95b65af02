using System;
using System.Collections.Generic;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Runs the code of a model in every interleaving of its synchronisation points, with everything that the memory may
/// show, every moment at which time may pass, and every early return of a wait.
/// </summary>
/// <remarks>
/// Depth first, each state once. That the number of interleavings comes out all the same is simple: those from a state
/// on are those from its successors on, added up. Nothing is taken by chance. Two things are not walked twice: places
/// in the code that go on alike (<see cref="CodeFold"/>), and retries of a compare-and-swap
/// (<see cref="RetriedUpdates"/>). A step that conflicts with no other is taken alone (<see cref="LoneWriters"/>), so
/// the interleavings that are counted are those that remain. Tests explore with and without.
/// </remarks>
internal sealed class Explorer
{
    private const int Time = -1;
    private const int MaxSteps = 1000;

    private readonly ExploredModel _model;
    private readonly ExploredMachine _machine;
    private readonly StateTable _known = new();
    private readonly List<ExploredState> _path = [];
    private readonly List<Step> _steps = [];
    private long _stepCount;
    private string? _fault;

    private Explorer(ExploredModel model, ExplorerOptions options)
    {
        _model = model;
        _machine = new ExploredMachine(model, options);
    }

    /// <summary>Explores to the end, or to the first fault.</summary>
    /// <param name="model">Made again for each exploration.</param>
    /// <param name="memory">What the memory may show.</param>
    public static ExplorationResult Explore(ExploredModel model, MemoryModel memory = MemoryModel.Weak)
        => Explore(model, new ExplorerOptions(memory));

    /// <inheritdoc cref="Explore(ExploredModel, MemoryModel)"/>
    public static ExplorationResult Explore(ExploredModel model, ExplorerOptions options)
        => new Explorer(model, options).Explore();

    private ExplorationResult Explore()
    {
        while (true)
        {
            try
            {
                _known.Clear();
                _steps.Clear();
                _stepCount = 0;
                _machine.Begin(StateAt(0));
                double interleavings = InterleavingsFrom(0);
                return new ExplorationResult(
                    _fault, _steps.ConvertAll(Describe), interleavings, _known.Count, _stepCount);
            }
            catch (CodeFold.ClaimBroken)
            {
                // Two places in the code are not alike: they are distinguished from now on.
            }
        }
    }

    private double InterleavingsFrom(int depth)
    {
        ExploredState state = StateAt(depth);
        StateKey key = state.Key();
        if (_known.TryGet(key, out double interleavings))
            return interleavings;

        if (depth == MaxSteps)
            throw new InvalidOperationException(
                $"No end after {MaxSteps} steps; the first: "
                    + $"{string.Join("; ", _steps.GetRange(0, 40).ConvertAll(Describe))}");
        interleavings = FreeThread(state) is { } free ? InterleavingsOf(free, depth, out _) : InterleavingsOfAll(depth);
        if (_fault is not null)
            return 0;
        if (interleavings == 0)
            interleavings = 1;
        _known.Add(key, interleavings);
        return interleavings;
    }

    private int? FreeThread(ExploredState state)
    {
        for (int thread = 0; thread < _machine.Threads; thread++)
        {
            if (_machine.IsFree(state, thread))
                return thread;
        }

        return null;
    }

    private double InterleavingsOfAll(int depth)
    {
        ExploredState state = StateAt(depth);
        double interleavings = 0;
        bool isQuiet = true;
        for (int thread = 0; thread < _machine.Threads && _fault is null; thread++)
        {
            interleavings += InterleavingsOf(thread, depth, out bool canRest);
            isQuiet &= canRest;
        }

        if (_fault is not null)
            return 0;
        if (isQuiet)
        {
            _model.CheckQuiet(state, thread => _machine.MayRest(state, thread));
            if ((_fault = state.Fault) is not null)
                return 0;
        }

        ExploredState next = StateAt(depth + 1);
        next.CopyFrom(state);
        if (_machine.TryLetTimePass(next))
            interleavings += InterleavingsAfter(new Step(Time, default, 0), depth + 1);
        return interleavings;
    }

    private double InterleavingsOf(int thread, int depth, out bool canRest)
    {
        double interleavings = 0;
        canRest = true;
        ExploredState state = StateAt(depth);
        ExploredState next = StateAt(depth + 1);
        SyncOperation operation = _machine.StepOf(state, thread);
        for (int choice = 0; _fault is null; choice++)
        {
            next.CopyFrom(state);
            StepKind kind = _machine.Take(next, thread, choice, out int result);
            if (kind == StepKind.NoSuchChoice)
                break;
            if (kind == StepKind.NotNow)
                continue;
            canRest &= kind == StepKind.WithoutReason;
            interleavings += InterleavingsAfter(new Step(thread, operation, result), depth + 1);
        }

        return interleavings;
    }

    private double InterleavingsAfter(in Step step, int depth)
    {
        _stepCount++;
        _steps.Add(step);
        _fault = StateAt(depth).Fault;
        double interleavings = _fault is null ? InterleavingsFrom(depth) : 0;
        if (_fault is null)
            _steps.RemoveAt(_steps.Count - 1);
        return interleavings;
    }

    private ExploredState StateAt(int depth)
    {
        if (depth == _path.Count)
            _path.Add(_machine.NewState());
        return _path[depth];
    }

    private string Describe(Step step)
    {
        if (step.Thread == Time)
            return "time passes";
        SyncOperation operation = step.Operation;
        string what = operation.Kind switch
        {
            SyncKind.Write or SyncKind.VolatileWrite or SyncKind.InterlockedWrite =>
                $"#{operation.Location} = {operation.Value}",
            SyncKind.Exchange => $"#{operation.Location} = {operation.Value}, was {step.Result}",
            SyncKind.CompareExchange =>
                $"#{operation.Location} = {operation.Value} if {operation.Comparand}, was {step.Result}",
            SyncKind.Fence or SyncKind.ReadClock => $"{step.Result}",
            _ => $"#{operation.Location}: {step.Result}",
        };
        return $"{_machine.NameOf(step.Thread)}: {operation.Kind} {what}";
    }

    private readonly record struct Step(int Thread, SyncOperation Operation, int Result);
}
