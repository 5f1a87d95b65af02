using System;
using System.Collections.Generic;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// A manager that enters and leaves units of work, and the watchdog that looks at it (contract 4.5): what is found
/// hanging is one stage, with its time, and the manager learns of it as it leaves that stage, and of nothing else.
/// </summary>
internal sealed class StageModel : ExploredModel
{
    private readonly StageMarkUnderTest _mark;
    private readonly int _stages;
    private readonly int _looks;

    public StageModel(StageMarkUnderTest mark, int stages, int looks)
    {
        _mark = mark;
        _stages = stages;
        _looks = looks;
        Threads = [new Manager(this), new Watchdog(this)];
    }

    public override IReadOnlyList<ExploredThread> Threads { get; }

    // For each stage: 1 for found by the watchdog, 2 for known to the manager, or both.
    public override int Notes => _stages;

    public override void CheckQuiet(ExploredState state, Func<int, bool> mayRest)
    {
        for (int stage = 0; stage < _stages; stage++)
            state.Require(
                state.Note(stage) is 0 or 3,
                state.Note(stage) == 1
                    ? $"stage {stage + 1} was found hanging, and the manager does not know"
                    : $"the manager takes itself for found in stage {stage + 1}");
    }

    private sealed class Manager(StageModel model) : ExploredThread("manager")
    {
        public override object Begin => 1;

        public override object? Run(object from)
        {
            int stage = (int)from;
            model._mark.Enter(stage);
            bool wasFound = model._mark.Leave();
            ExploredSyncPoints.Note((stage, wasFound), s =>
            {
                if (wasFound)
                    s.Note(stage - 1) |= 2;
            });
            return stage < model._stages ? stage + 1 : null;
        }
    }

    private sealed class Watchdog(StageModel model) : ExploredThread("watchdog")
    {
        public override object Begin => 1;

        public override object? Run(object from)
        {
            int look = (int)from;

            // The time is the number of the stage.
            if (model._mark.TryRead(out int seen, out int kind, out int since))
            {
                ExploredSyncPoints.Note(
                    (kind, since), s => s.Require(kind == (since & 1), $"the time {since} is not that of the stage"));
                if (model._mark.TryMarkHanging(seen))
                    ExploredSyncPoints.Note(("found", since), s => Find(s, since));
            }

            return look < model._looks ? look + 1 : null;
        }

        private static void Find(ExploredState s, int stage)
        {
            s.Require(stage > 0 && s.Note(stage - 1) is 0 or 2, $"stage {stage} was found twice");
            if (stage > 0)
                s.Note(stage - 1) |= 1;
        }
    }
}
