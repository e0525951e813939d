#pragma once
/// Of the contacts, those that close.
class Crew;
