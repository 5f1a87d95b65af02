using System;
using Rabit.Core;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>A picture on its way to the folder. The holder owns its buffer. A plain value.</summary>
internal struct PictureToKeep : IDisposable
{
    /// <summary>Red, green and blue, row by row.</summary>
    public BufferLease Pixels { get; set; }

    public int Width { get; set; }

    public int Height { get; set; }

    public PhotoMetadata Metadata { get; set; }

    public PictureFileName Name { get; set; }

    public readonly void Dispose() => Pixels.Dispose();
}
