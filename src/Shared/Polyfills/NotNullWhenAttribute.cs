#if NETSTANDARD2_0
namespace System.Diagnostics.CodeAnalysis;

/// <summary>
/// States to the compiler that a parameter is not null when the method returns a given value; netstandard2.0 lacks it.
/// </summary>
[AttributeUsage(AttributeTargets.Parameter)]
internal sealed class NotNullWhenAttribute(bool returnValue) : Attribute
{
    /// <summary>The value returned when the parameter is not null.</summary>
    public bool ReturnValue { get; } = returnValue;
}
#endif
