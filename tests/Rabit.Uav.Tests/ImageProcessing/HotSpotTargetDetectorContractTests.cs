using System;
using System.Collections.Immutable;
using System.Runtime.InteropServices;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>The contract with thermal pictures: what is red in those of the contract is warm.</summary>
public sealed class HotSpotTargetDetectorContractTests : TargetDetectorContract
{
    public HotSpotTargetDetectorContractTests()
        : base(new HotSpotTargetDetector(
            [new TargetClass(DefaultTargetClasses.Red.ToString()) { HotSpot = new HotSpotTarget() }]))
    {
    }

    protected override DetectorInput Input(byte[] picture, ImmutableArray<TargetClass> classes)
        => new(
            picture, Painting.Width, Painting.Height, classes, PictureGroundScale.Uniform(1 / PixelsPerMetre),
            PixelFormat.Grey16);

    protected override byte[] Finish(byte[] painted)
    {
        byte[] bytes = new byte[painted.Length / 3 * 2];
        Span<ushort> counts = MemoryMarshal.Cast<byte, ushort>(bytes.AsSpan());
        for (int i = 0; i < counts.Length; i++)
            counts[i] = (ushort)(8000 + (8 * (painted[3 * i] - painted[(3 * i) + 1])));
        return bytes;
    }
}
