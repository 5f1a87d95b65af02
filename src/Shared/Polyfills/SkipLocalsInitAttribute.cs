#if !NET
namespace System.Runtime.CompilerServices;

/// <summary>
/// Lets the compiler leave stack memory as it is on netstandard2.0, where a method writes it before it reads it.
/// </summary>
[AttributeUsage(AttributeTargets.Method, Inherited = false)]
internal sealed class SkipLocalsInitAttribute : Attribute;
#endif
