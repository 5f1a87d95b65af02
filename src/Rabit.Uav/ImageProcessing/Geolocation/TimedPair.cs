namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>Two samples around a moment. A plain value.</summary>
internal struct TimedPair<T>
{
    public T Before;
    public T After;

    /// <summary>From one to the other.</summary>
    public double Seconds;

    /// <summary>Where the moment is between them, 0 to 1.</summary>
    public double Part;
}
