using System;
using Rabit.Core.Supervision;

namespace Rabit.Core.Tests.Exploration;

/// <summary>The mark of the library.</summary>
internal sealed class ProductionStageMark : StageMarkUnderTest
{
    private readonly StageMark<ExploredSyncPoints> _mark = new();

    public override void Enter(int time) => _mark.Enter((ManagerStage)(time & 1), TimeSpan.FromTicks(time));

    public override bool Leave() => _mark.Leave();

    public override bool TryRead(out int seen, out int kind, out int since)
    {
        bool isIn = _mark.TryRead(out seen, out ManagerStage stage, out TimeSpan time);
        kind = (int)stage;
        since = (int)time.Ticks;
        return isIn;
    }

    public override bool TryMarkHanging(int seen) => _mark.TryMarkHanging(seen);
}
