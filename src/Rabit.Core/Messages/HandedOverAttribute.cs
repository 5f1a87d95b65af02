using System;

namespace Rabit.Core;

/// <summary>
/// States that a value of this type has one owner at a time, and that pushing it into a queue hands it over: its
/// sender touches it no more. A queue of a type that can be changed is otherwise a note of the wiring, or a fault
/// (<see cref="ReactorOptions.RefusesMutableQueueTypes"/>). A type that is <see cref="IDisposable"/> needs no such
/// statement, nor does one that a message may hold.
/// </summary>
[AttributeUsage(AttributeTargets.Class | AttributeTargets.Struct | AttributeTargets.Interface, Inherited = false)]
public sealed class HandedOverAttribute : Attribute;
