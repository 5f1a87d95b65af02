using System;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>The contract with black panels: what is red in its pictures is black here.</summary>
public sealed class PanelTargetDetectorContractTests : TargetDetectorContract
{
    public PanelTargetDetectorContractTests()
        : base(new PanelTargetDetector(
            [new TargetClass(DefaultTargetClasses.Red.ToString()) { Colour = new ColourRange(20, 20, 20) }]))
    {
    }

    protected override byte[] Finish(byte[] painted)
    {
        for (int i = 0; i < painted.Length; i += 3)
        {
            // Grass is green; what is redder is panel in part.
            double part = Math.Max(0, Math.Min(1, (painted[i] - painted[i + 1] + 26) / 203.0));
            for (int channel = 0; channel < 3; channel++)
                painted[i + channel] = (byte)Math.Max(0, (painted[i + channel] * (1 - (part / 2))) - (80 * part));
        }

        return painted;
    }
}
