using System;
using Rabit.Geodesy;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>A measured place as a track takes it. A plain value.</summary>
/// <param name="Key">Its identity: source, picture, index.</param>
/// <param name="Time">When it was true.</param>
/// <param name="North">Measured, metres in the local frame.</param>
/// <param name="East">Measured.</param>
/// <param name="Covariance">What differs from one measurement to the next.</param>
/// <param name="Registration">What is the same in all measurements of its source: the offset of its frame.</param>
internal readonly record struct TrackMeasurement(
    ReportKey Key,
    TimeSpan Time,
    double North,
    double East,
    HorizontalCovariance Covariance,
    HorizontalCovariance Registration);
