namespace Rabit.Vision;

/// <summary>
/// What a form is like whatever its size, its direction, and how much longer than wide it is: its area by its spread,
/// and its moments of third and fourth order after it was stretched to the same spread in all directions. Blur that is
/// the same in all directions does not change these two. A plain value.
/// </summary>
public struct FormMoments
{
    /// <summary>
    /// Its area, by that of a rectangle of the same spread: 1 for a rectangle, 1.05 for a circle, 0.87 for a triangle,
    /// 0.86 for a cross whose arms are a third of its span wide.
    /// </summary>
    public double Fill { get; set; }

    /// <summary>
    /// How much three directions differ from those between them: 0.8 for a triangle; 0 for what looks the same when it
    /// is turned by half a turn.
    /// </summary>
    public double Third { get; set; }

    /// <summary>
    /// How much four directions differ from those between them: 0.6 for a square, 0.84 for that cross; 0 for a circle
    /// and a triangle.
    /// </summary>
    public double Fourth { get; set; }
}
