namespace Greenhouse._1;

/// <summary>
/// What the thermometer measures. It is a message: who reads it wants the latest value. A message is a plain struct or
/// an immutable class.
/// </summary>
public struct AirTemperature
{
    public double Celsius;
}
