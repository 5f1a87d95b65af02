using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>
/// A camera that never blocks: it shows one picture again and again, each some time after its exposure, and does what
/// else the test says.
/// </summary>
internal sealed class ScriptedCamera(byte[] picture, int buffers = 6) : IReaderSource<CameraFrame>
{
    private readonly Queue<(TimeSpan At, CameraFrame Frame)> _frames = new();
    private ReaderContext? _context;

    public BufferPool Pool { get; } = new("camera", buffers, Math.Max(1, picture.Length));

    public bool Blocks => false;

    /// <summary>Thrown by the read after all pictures.</summary>
    public Exception? Fault { get; set; }

    /// <summary>Whether the read after all pictures says that there are no more.</summary>
    public bool Ends { get; set; }

    /// <summary>The size that its pictures claim to have.</summary>
    public (int Width, int Height) Size { get; set; } = (Painting.Width, Painting.Height);

    /// <summary>How its pictures are arranged.</summary>
    public PixelFormat Format { get; set; }

    /// <summary>Pictures for which there was no buffer.</summary>
    public int Lost { get; private set; }

    public void Add(long number, double exposedAt, double deliveredAt)
    {
        var frame = new CameraFrame
        {
            Number = number,
            Width = Size.Width,
            Height = Size.Height,
            Format = Format,
            FrameStart = TimeSpan.FromSeconds(exposedAt - 0.001),
            Exposure = TimeSpan.FromMilliseconds(2),
        };
        _frames.Enqueue((TimeSpan.FromSeconds(deliveredAt), frame));
        _context?.Signal();
    }

    public void Open(ReaderContext context) => _context = context;

    public ReaderStep Read(out CameraFrame value)
    {
        value = default;
        while (_frames.Count > 0)
        {
            if (_context!.Now < _frames.Peek().At)
                return ReaderStep.WaitUntil(_frames.Peek().At);
            value = _frames.Dequeue().Frame;
            if (Pool.TryRent("camera", out BufferLease lease))
            {
                picture.CopyTo(lease.Array, 0);
                value.Pixels = lease;
                return ReaderStep.Value;
            }

            Lost++;
        }

        if (Fault is not null)
            throw Fault;
        return Ends ? ReaderStep.Ended : ReaderStep.WaitForSignal;
    }

    public void Unblock()
    {
    }

    public void Close()
    {
    }
}
