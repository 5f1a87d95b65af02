using System;

namespace Rabit.Core.Tests.Exploration;

/// <summary>A short thread: all its code is one piece.</summary>
internal sealed class OnePieceThread(string name, Action code) : ExploredThread(name)
{
    public override object Begin => Name;

    public override object? Run(object from)
    {
        code();
        return null;
    }
}
