using System;
using Rabit.Uav.ImageProcessing;

namespace Rabit.Uav.Simulation.Tests.Vision;

/// <summary>A drawn target of which a part may not be seen.</summary>
/// <param name="Form">The whole.</param>
/// <param name="Name">Of its class.</param>
/// <param name="SeenX">Column of the centre of what can be seen.</param>
/// <param name="SeenY">Row of that.</param>
/// <param name="Part">Which part of its area can be seen.</param>
internal sealed record PartialTarget(DrawnForm Form, string Name, double SeenX, double SeenY, double Part)
{
    public bool IsFoundBy(TargetDetection found)
    {
        double reach = Math.Max(3, 0.5 * Form.Side);
        (double x, double y) = (found.CentreX - SeenX, found.CentreY - SeenY);
        return found.Class.ToString() == Name && (x * x) + (y * y) <= reach * reach;
    }
}
