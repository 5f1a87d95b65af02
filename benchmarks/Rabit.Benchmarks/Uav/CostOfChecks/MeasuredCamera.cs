using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Benchmarks.Uav.CostOfChecks;

/// <summary>A camera, the processor time that its pictures take, and on demand some of its pictures.</summary>
internal sealed class MeasuredCamera(IReaderSource<CameraFrame> camera) : IReaderSource<CameraFrame>
{
    private const int MaxKept = 16;
    private const int KeptOneOf = 8;

    private readonly List<byte[]> _kept = [];

    public bool Blocks => camera.Blocks;

    /// <summary>Whether pictures are kept: one of eight, up to sixteen.</summary>
    public bool Keeps { get; set; }

    public IReadOnlyList<byte[]> Kept => _kept;

    /// <summary>Columns of the pictures that were kept.</summary>
    public int Width { get; private set; }

    /// <summary>Rows of the pictures that were kept.</summary>
    public int Height { get; private set; }

    /// <summary>The time of the processor for making the pictures.</summary>
    public TimeSpan Cpu { get; private set; }

    public void Open(ReaderContext context) => camera.Open(context);

    public ReaderStep Read(out CameraFrame value)
    {
        TimeSpan before = Environment.CpuUsage.TotalTime;
        ReaderStep step = camera.Read(out value);
        Cpu += Environment.CpuUsage.TotalTime - before;
        if (Keeps && step.Kind == ReaderStepKind.Value && value.Number % KeptOneOf == 0 && _kept.Count < MaxKept)
        {
            (Width, Height) = (value.Width, value.Height);
            _kept.Add(value.Pixels.Array.AsSpan(0, value.Width * value.Height * 3).ToArray());
        }

        return step;
    }

    public void Unblock() => camera.Unblock();

    public void Close() => camera.Close();
}
