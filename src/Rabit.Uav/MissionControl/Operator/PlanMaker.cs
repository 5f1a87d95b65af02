using Rabit.Core;

namespace Rabit.Uav.MissionControl;

/// <summary>Plans on a thread of its own what the operator has changed.</summary>
internal sealed class PlanMaker : IWriterTarget<PlanJob>
{
    /// <summary>One is at work, and others have replaced it.</summary>
    public const int MaxWaiting = 4;

    /// <summary>Planning takes its time, and ends by itself.</summary>
    public bool Blocks => false;

    public void Open()
    {
    }

    public void Write(in PlanJob value) => value.Make();

    public void Unblock()
    {
    }

    public void Close()
    {
    }
}
