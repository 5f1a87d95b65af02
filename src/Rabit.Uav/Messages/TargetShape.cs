namespace Rabit.Uav.Messages;

/// <summary>The outline of a target as seen from above, where its class declares one.</summary>
public enum TargetShape
{
    /// <summary>Any compact form: a square, a circle, a cross, a triangle, a car.</summary>
    Any,

    /// <summary>A square, or a rectangle within the aspects of the class.</summary>
    Rectangle,

    /// <summary>A circle, or an ellipse within the aspects of the class.</summary>
    Circle,

    /// <summary>Two bars of the same length across each other, 0.2 to 0.36 as wide as long.</summary>
    Cross,

    /// <summary>A triangle; the aspect of one with equal sides is 1.</summary>
    Triangle,
}
