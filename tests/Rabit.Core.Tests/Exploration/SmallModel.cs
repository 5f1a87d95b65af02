using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Core.Tests.Exploration;

/// <summary>A few short threads, and a check at each end.</summary>
internal sealed class SmallModel(int notes, Action<ExploredState> check, params Action[] threads) : ExploredModel
{
    public override IReadOnlyList<ExploredThread> Threads { get; } =
        threads.Select((code, i) => new OnePieceThread($"thread {i}", code)).ToArray();

    public override int Notes => notes;

    public override bool FencesAllThreads => MayFenceAll;

    /// <summary>See <see cref="FencesAllThreads"/>.</summary>
    public bool MayFenceAll { get; init; }

    public override (int Locations, int Signals, int Writes) Size => (Locations, 1, 12);

    /// <summary>How many locations the code has.</summary>
    public int Locations { get; init; } = 8;

    public override void CheckQuiet(ExploredState state, Func<int, bool> mayRest) => check(state);
}
