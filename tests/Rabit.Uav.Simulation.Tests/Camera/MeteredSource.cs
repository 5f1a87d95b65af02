using Rabit.Core;
using Rabit.Tests.Shared;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation.Tests.Camera;

/// <summary>Passes a camera on, and measures what the last reads allocate.</summary>
internal sealed class MeteredSource(IReaderSource<CameraFrame> camera) : IReaderSource<CameraFrame>
{
    private CameraFrame _frame;
    private ReaderStep _step;

    public bool Blocks => camera.Blocks;

    public long LastAllocated { get; private set; }

    public void Open(ReaderContext context) => camera.Open(context);

    public ReaderStep Read(out CameraFrame value)
    {
        LastAllocated = Allocated.By(ReadOnce, prepare: null);
        value = _frame;
        return _step;
    }

    public void Unblock() => camera.Unblock();

    public void Close() => camera.Close();

    private void ReadOnce() => _step = camera.Read(out _frame);
}
