namespace Rabit.Core.RealTimeKit;

/// <summary>Whether a thread may spin before it sleeps. Asked by that thread; see <see cref="SharedCpus"/>.</summary>
/// <param name="cpus">Of the run.</param>
/// <param name="onlyCpu">The one CPU on which the thread may run; -1 where there are several.</param>
internal sealed class SpinPermit(SharedCpus cpus, int onlyCpu)
{
    public bool IsGiven => cpus.MaySpin(onlyCpu);
}
