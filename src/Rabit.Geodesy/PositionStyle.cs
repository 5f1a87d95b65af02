namespace Rabit.Geodesy;

/// <summary>How a position is written.</summary>
public enum PositionStyle
{
    /// <summary>As 47.3976543, 8.5456789: a centimetre.</summary>
    DecimalDegrees,

    /// <summary>As 47°23'51.555"N 8°32'44.444"E: three centimetres.</summary>
    DegreesMinutesSeconds,

    /// <summary>As 32TMT6500050000: the square of a metre. Not near the poles.</summary>
    Mgrs,
}
