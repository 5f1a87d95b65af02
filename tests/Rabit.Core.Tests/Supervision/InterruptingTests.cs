using System;
using System.Threading;

namespace Rabit.Core.Tests.Supervision;

/// <summary>
/// Tests that may leave an interrupt pending on their own thread, where it would end a wait of another test.
/// </summary>
public abstract class InterruptingTests : IDisposable
{
    public void Dispose()
    {
        GC.SuppressFinalize(this);
        using var never = new ManualResetEvent(initialState: false);
        try
        {
            never.WaitOne(1);
        }
        catch (ThreadInterruptedException)
        {
            // That it ends here is the purpose.
        }
    }
}
